#pragma once
// The subpaths of an SVG path of m, h, v, l, a and z in relative whole numbers, read back.

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "tools/report/svg_path.h"

namespace enfilade::testing {

class PathReader {
public:
    explicit PathReader(const std::string& text) : at_(text.data()), end_(text.data() + text.size()) {}

    std::vector<std::vector<tools::Mm>> rings() {
        char command = 0;
        while (at_ != end_) {
            if (*at_ >= 'a' && *at_ <= 'z') command = *at_++;
            step(command);
        }
        return rings_;
    }

private:
    void step(char command) {
        switch (command) {
            case 'm': point_.x += number(), point_.y += number(), rings_.push_back({point_}); return;
            case 'h': point_.x += number(); break;
            case 'v': point_.y += number(); break;
            case 'l': point_.x += number(), point_.y += number(); break;
            case 'a':
                for (int k = 0; k < 5; ++k) number();
                point_.x += number(), point_.y += number();
                break;
            case 'z': point_ = rings_.back().front(); return;
            default:
                ADD_FAILURE() << "command " << command;
                at_ = end_;
                return;
        }
        rings_.back().push_back(point_);
    }
    std::int64_t number() {
        while (at_ != end_ && *at_ == ' ') ++at_;
        std::int64_t value = 0;
        const auto [stop, error] = std::from_chars(at_, end_, value);
        EXPECT_EQ(error, std::errc());
        at_ = error == std::errc() ? stop : end_;
        return value;
    }

    const char* at_;
    const char* end_;
    tools::Mm point_;
    std::vector<std::vector<tools::Mm>> rings_;
};

/// Square metres inside a path whose holes run the other way round.
inline double path_area(const std::string& text) {
    double twice = 0;
    for (const auto& ring : PathReader(text).rings())
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const tools::Mm a = ring[k], b = ring[(k + 1) % ring.size()];
            twice += double(a.x) * double(b.y) - double(a.y) * double(b.x);
        }
    return twice / 2e6;
}

}  // namespace enfilade::testing
