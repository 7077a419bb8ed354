// SPDX-License-Identifier: Apache-2.0

#include "certificate_lines.h"

namespace wellstrat {
inline namespace stream1 {

const std::vector<NetPromise>& netPromises() {
    static const std::vector<NetPromise> promises = {
        {"x: one point in each of 2^m strata", {0}, 0, NetBase::two},
        {"y: one point in each of 2^m strata", {1}, 0, NetBase::two},
        {"z: one point in each of 2^m strata", {2}, 0, NetBase::two},
        {"(x, y): (0,m,2)-net in base 2", {0, 1}, 0, NetBase::two},
        {"(x, y, z): (1,m,3)-net in base 2", {0, 1, 2}, 1, NetBase::two},
        {"(x, y, z): one point in each base-4 box, m even", {0, 1, 2}, 0, NetBase::four},
    };
    return promises;
}

CertificateLines netLines(const std::string& subject) {
    CertificateLines lines;
    for (const NetPromise& promise : netPromises()) {
        lines.push_back(emptyLine(promise.text, subject));
    }
    return lines;
}

bool isUnitMultiple(float value) {
    if (!(value >= 0.0f && value < 1.0f)) return false;
    const float scaled = value * 0x1p24f;
    return static_cast<float>(static_cast<uint32_t>(scaled)) == scaled;
}

uint32_t fractionOf(float value) {
    return isUnitMultiple(value) ? static_cast<uint32_t>(value * 0x1p24f) << 8 : 0;
}

DrawChecker::DrawChecker(CertificateLines& lines, const std::string& subject)
    : lines_(lines), draws_(lines.size()) {
    lines.push_back(
        emptyLine("1D draw = z, 2D draw = (x, y), batch = single draws", "samples of " + subject));
    lines.push_back(emptyLine("values in [0, 1), multiples of 2^-24", "values of " + subject));
}

void DrawChecker::resize(std::size_t count) {
    xi1_.resize(count);
    xi2_.resize(count);
    xi3_.resize(count);
    bits_.resize(3 * count);
}

} // namespace stream1
} // namespace wellstrat
