#include "accel/sha256.h"

#include <gtest/gtest.h>

#include <random>
#include <string_view>
#include <vector>

namespace enfilade::accel {
namespace {

std::string hash_of(std::string_view text) { return hex(sha256(std::as_bytes(std::span(text)))); }

// FIPS 180-4 and NIST's example files.
TEST(Sha256, AgreesWithThePublishedExamples) {
    EXPECT_EQ(hash_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(hash_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(hash_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(hash_of(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, OfTheProcessorEqualsThePortableOneForAllTailLengths) {
    std::mt19937 random(1);
    std::vector<std::byte> bytes(513);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
    for (std::size_t n = 0; n <= bytes.size(); ++n) {
        const std::span<const std::byte> part(bytes.data(), n);
        ASSERT_EQ(sha256(part), sha256_portable(part)) << n << " bytes";
    }
}

}  // namespace
}  // namespace enfilade::accel
