// SPDX-License-Identifier: Apache-2.0
//
// Pictures written to memory by OpenImageIO.

#pragma once

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace wellstrat::render {

/// A picture being written to memory, in the format that the suffix stands for. Throws
/// std::runtime_error.
class ImageEncoder {
public:
    ImageEncoder(const std::string& suffix, OIIO::ImageSpec spec)
        : output_(OIIO::ImageOutput::create("film" + suffix)) {
        if (!output_) throw std::runtime_error(OIIO::geterror());
        void* proxy = &memory_;
        spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
        spec.attribute("DateTime", "");
        check(output_->open("film" + suffix, spec));
    }
    /// Rows from `begin` to `end` (exclusive), in the channels' own types.
    void write(unsigned begin, unsigned end, const void* rows) {
        check(output_->write_scanlines(static_cast<int>(begin), static_cast<int>(end), 0,
                                       OIIO::TypeDesc::UNKNOWN, rows));
    }
    std::string finish() {
        check(output_->close());
        return {bytes_.begin(), bytes_.end()};
    }

private:
    void check(bool success) const {
        if (!success) throw std::runtime_error(output_->geterror());
    }

    std::vector<unsigned char> bytes_;
    OIIO::Filesystem::IOVecOutput memory_{bytes_};
    std::unique_ptr<OIIO::ImageOutput> output_;
};

} // namespace wellstrat::render
