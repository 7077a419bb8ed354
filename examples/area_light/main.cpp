// SPDX-License-Identifier: Apache-2.0
//
// Renders the soft shadow of a sphere under a rectangular light with well-stratified and with
// random samples, and prints how far each is from the converged image.

#include "image_file.h"
#include "integrator.h"

#include "wellstrat/random_generator.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>

using namespace area_light;

namespace {

struct Options {
    std::string output = "area_light_out";
    unsigned size = 256;
    unsigned maxSamples = 256;
    unsigned threads = std::max(1u, std::thread::hardware_concurrency());
};

/// Frames of the images. The two halves of the reference share no sample with what is measured.
enum Frame : unsigned { kMeasured, kReferenceA, kReferenceB };

constexpr unsigned kReferenceSamples = 1024; // of each half

const wellstrat::RandomGenerator kRandom;

/// The converged image, and how far it is from the limit.
struct Reference {
    Image image;
    double error;
};

Image renderWith(const Options& options, const RixRNG::Generator* generator, Branching branching,
                 unsigned samples, Frame frame = kMeasured) {
    return render({options.size, samples, branching, generator, frame, options.threads});
}

/// The mean of two independent images. Half their difference estimates the error of the mean.
Reference makeReference(const Options& options) {
    Image a = renderWith(options, nullptr, Branching::plain, kReferenceSamples, kReferenceA);
    const Image b = renderWith(options, nullptr, Branching::plain, kReferenceSamples, kReferenceB);
    const double error = 0.5 * rmse(a, b);
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = (a[i] + b[i]) * 0.5f;
    return {std::move(a), error};
}

void createFolder(const std::string& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) {
        throw std::runtime_error(
            fmt::format("cannot make the folder '{}': {}", path, error.message()));
    }
}

void writeImage(const Options& options, const std::string& name,
                const std::vector<const Image*>& images) {
    writePng((std::filesystem::path(options.output) / name).string(), options.size, images);
}

/// Renders one line of the table with both kinds of samples.
void compare(const Options& options, const Image& reference, Branching branching, const char* name,
             unsigned samples) {
    const Image random = renderWith(options, &kRandom, branching, samples);
    const Image pmj = renderWith(options, nullptr, branching, samples);
    const double randomError = rmse(random, reference);
    const double pmjError = rmse(pmj, reference);
    fmt::print("{:<13} {:>5} {:>5} {:>11.5f} {:>11.5f} {:>9.2f}\n", name, samples,
               samples / branchCount(branching), randomError, pmjError, pmjError / randomError);
    std::fflush(stdout);
    writeImage(options, fmt::format("{}_{:04}.png", name, samples), {&random, &pmj});
}

void run(const Options& options) {
    createFolder(options.output);
    const Reference reference = makeReference(options);
    writeImage(options, "reference.png", {&reference.image});

    fmt::print(
        "{0}x{0} pixels. RMSE against a reference of {1} pmj samples of two other frames,\n"
        "whose own error is about {2:.5f}.\n\n"
        "{3:<13} {4:>5} {5:>5} {6:>11} {7:>11} {8:>9}\n",
        options.size, 2 * kReferenceSamples, reference.error, "branching", "spp", "rays", "random",
        "pmj", "ratio");
    const std::pair<Branching, const char*> branchings[] = {
        {Branching::plain, "plain"},
        {Branching::split, "split"},
        {Branching::distribution, "distribution"},
    };
    for (const auto& [branching, name] : branchings) {
        for (unsigned samples = branchCount(branching); samples <= options.maxSamples;
             samples *= 4) {
            compare(options, reference.image, branching, name, samples);
        }
    }
    fmt::print(
        "\nspp: light samples per pixel; rays: camera rays per pixel; ratio: pmj / random.\n"
        "Images, random left and pmj right, are in {}\n",
        options.output);
}

/// Returns an exit code, or -1 to go on.
int parse(int argc, char** argv, Options& options) {
    CLI::App app{
        "Renders a soft shadow with random and with well-stratified (pmj) samples, writes\n"
        "the images and prints their errors.",
        "area_light"};
    app.add_option("output", options.output, "Folder for the images")->capture_default_str();
    app.add_option("--size", options.size, "Width and height of the images in pixels")
        ->check(CLI::Range(1u, 4096u))
        ->capture_default_str();
    app.add_option("--max-spp", options.maxSamples, "Highest number of samples per pixel")
        ->check(CLI::Range(1u, 65536u))
        ->capture_default_str();
    app.add_option("--threads", options.threads, "Number of threads; results do not depend on it")
        ->check(CLI::Range(1u, 1024u));
    app.footer("Example: area_light --size 128 --max-spp 16 images");
    try {
        app.parse(argc, argv);
        return -1;
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr, "area_light: {}\n", error.what());
        return 2;
    }
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    try {
        const int exitCode = parse(argc, argv, options);
        if (exitCode >= 0) return exitCode;
        run(options);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "area_light: {}\n", error.what());
        return 2;
    }
}
