#include "support/golden/golden.hpp"

#include <cstdlib>
#include <cstring>

namespace ciel::test {
namespace {

namespace fs = std::filesystem;

struct Files {
    fs::path golden, actual, expected, difference;

    Files(const std::string& name, const std::string& label)
        : golden(fs::path(CIEL_SOURCE_DIR) / "tests/golden/pictures" / (name + ".png")) {
        const fs::path folder = fs::path(CIEL_BINARY_DIR) / "pictures/golden";
        const std::string stem = label.empty() ? name : name + "." + label;
        actual = folder / (stem + ".actual.png");
        expected = folder / (stem + ".expected.png");
        difference = folder / (stem + ".difference.png");
    }
    void forget() const {
        std::error_code absent;
        for (const fs::path& file : {actual, expected, difference}) fs::remove(file, absent);
    }
};

bool is_accepting() {
    const char* accept = std::getenv("CIEL_ACCEPT_PICTURES");
    return accept != nullptr && std::strcmp(accept, "1") == 0;
}

constexpr const char* how_to_accept = "; look at it, and if it is right run the test with CIEL_ACCEPT_PICTURES=1";

} // namespace

testing::AssertionResult matches_golden(const std::string& name, const Picture& picture, const std::string& label,
                                        const Tolerance& tolerance) {
    const Files files(name, label);
    files.forget();
    if (is_accepting()) {
        write_png(files.golden, picture);
        return testing::AssertionSuccess();
    }
    const auto fail = [&](const std::string& reason) {
        write_png(files.actual, picture);
        return testing::AssertionFailure()
               << name << ": " << reason << "; what was drawn is in " << files.actual << how_to_accept;
    };
    if (!fs::exists(files.golden)) return fail("there is no golden image " + files.golden.string());
    const Picture golden = read_png(files.golden);
    if (golden.width != picture.width || golden.height != picture.height)
        return fail("the golden image is " + std::to_string(golden.width) + " x " + std::to_string(golden.height) +
                    ", the picture " + std::to_string(picture.width) + " x " + std::to_string(picture.height));
    const Difference found = difference(golden, picture);
    if (is_within(found, tolerance)) return testing::AssertionSuccess() << words(found, tolerance);
    write_png(files.expected, golden);
    write_png(files.difference, difference_picture(golden, picture));
    return fail(words(found, tolerance));
}

} // namespace ciel::test
