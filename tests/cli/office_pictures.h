#pragma once
// Small pictures from inside of an office's first room, by the program.

#include "render/image_file.h"
#include "tests/cli/program.h"

namespace enfilade::test {

using Words = std::vector<std::string>;

class OfficePictures : public OfficeTest {
protected:
    /// flags: all but the picture's name and the room.
    static Outcome rendered(const std::string& picture, const Words& flags) {
        Words all = {"render", "office.enf", "-o", picture, "--room", "Office 0.004"};
        all.insert(all.end(), flags.begin(), flags.end());
        return run(all);
    }
    /// What it says with --json.
    static nlohmann::json told(const std::string& picture, Words flags) {
        flags.emplace_back("--json");
        const Outcome outcome = rendered(picture, flags);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return nlohmann::json::parse(outcome.out, nullptr, false);
    }
    static render::Image image(const std::string& picture) { return render::read_image(folder() / picture); }
    static double mean(const render::Image& image) {
        double sum = 0;
        for (const float v : image.rgb) sum += double{v};
        return sum / double(image.rgb.size());
    }
    /// One list of flags behind the other.
    static Words joined(Words flags, const Words& more) {
        flags.insert(flags.end(), more.begin(), more.end());
        return flags;
    }
};

}  // namespace enfilade::test
