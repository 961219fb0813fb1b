#pragma once
// Random numbers that are the same on every machine, keyed by what they are for (1-architecture, decision 10).

#include <cstdint>
#include <initializer_list>

namespace enfilade::plans {

/// SplitMix64 (Steele, Lea, Flood 2014): every key opens its own stream.
class Random {
public:
    explicit Random(std::initializer_list<std::uint64_t> key) {
        for (const std::uint64_t part : key) state_ = mixed(state_ ^ part) + golden;
    }

    std::uint64_t next() { return mixed(state_ += golden); }
    /// In [0, 1), with 53 bits.
    double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    /// In [0, count). \pre count > 0
    std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(((next() >> 32) * count) >> 32); }
    bool chance(double share) { return uniform() < share; }

private:
    static constexpr std::uint64_t golden = 0x9E3779B97F4A7C15u;
    static std::uint64_t mixed(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }

    std::uint64_t state_ = golden;
};

}  // namespace enfilade::plans
