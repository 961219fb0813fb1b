// Files of rays: what is read, and what is refused with which sentence. Nothing may crash.

#include "tools/npy.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <random>

#include "base/error.h"
#include "tests/support/temporary_folder.h"

namespace enfilade::tools {
namespace {

std::string file_text(const std::string& dictionary, const std::string& data, int version = 1) {
    std::string text = "\x93NUMPY";
    text += char(version);
    text += '\0';
    for (int k = 0; k < (version == 1 ? 2 : 4); ++k) text += char(dictionary.size() >> 8 * k & 0xff);
    return text + dictionary + data;
}

std::string rays_header(const std::string& descr = "'<f8'", const std::string& shape = "(2, 6)",
                        const std::string& order = "False") {
    return "{'descr': " + descr + ", 'fortran_order': " + order + ", 'shape': " + shape + ", }   \n";
}

std::string numbers(std::size_t count) {
    std::string data(8 * count, '\0');
    for (std::size_t i = 0; i < count; ++i) {
        const double number = double(i) + 0.5;
        std::memcpy(data.data() + 8 * i, &number, 8);
    }
    return data;
}

class RayFiles : public testing::Test {
protected:
    std::filesystem::path written(const std::string& text) {
        std::ofstream(path_, std::ios::binary).write(text.data(), std::streamsize(text.size()));
        return path_;
    }
    /// The code with which the file is refused.
    std::string refusal(const std::string& text) {
        try {
            const RayFile rays(written(text));
        } catch (const InputError& error) {
            const std::string sentence = error.what();
            EXPECT_EQ(sentence.back(), '.');
            EXPECT_EQ(sentence.find('\n'), std::string::npos);
            EXPECT_NE(sentence.find(": "), std::string::npos) << "no remedy: " << sentence;
            EXPECT_EQ(error.file, path_.string());
            return error.code;
        }
        return "none";
    }

private:
    test::TemporaryFolder folder_;
    std::filesystem::path path_ = folder_.path() / "rays.npy";
};

TEST_F(RayFiles, AreReadInEveryVersion) {
    for (const int version : {1, 2, 3}) {
        const RayFile rays(written(file_text(rays_header(), numbers(12), version)));
        EXPECT_EQ(rays.count(), 2u);
        EXPECT_FALSE(rays.has_distance());
        std::vector<double> second(6);
        rays.read(1, second);
        EXPECT_EQ(second, (std::vector<double>{6.5, 7.5, 8.5, 9.5, 10.5, 11.5}));
    }
}

TEST_F(RayFiles, OfFloatsAreWidened) {
    std::string data(4 * 14, '\0');
    for (int i = 0; i < 14; ++i) {
        const float number = 0.1f * float(i);
        std::memcpy(data.data() + 4 * i, &number, 4);
    }
    const RayFile rays(written(file_text(rays_header("'<f4'", "(2, 7)"), data)));
    EXPECT_TRUE(rays.has_distance());
    std::vector<double> all(14);
    rays.read(0, all);
    for (int i = 0; i < 14; ++i) EXPECT_EQ(all[std::size_t(i)], double{0.1f * float(i)});
}

TEST_F(RayFiles, MayBeEmpty) {
    const RayFile rays(written(file_text(rays_header("'<f8'", "(0, 6)"), "")));
    EXPECT_EQ(rays.count(), 0u);
}

TEST_F(RayFiles, InWhateverOrderAndQuotesTheHeaderHas) {
    EXPECT_EQ(refusal(file_text("{\"shape\": (2L, 6L), \"fortran_order\": False, \"descr\": \"<f8\"}", numbers(12))),
              "none");
}

TEST_F(RayFiles, OfAnotherTypeAreRefused) {
    for (const char* descr : {"'>f8'", "'<f2'", "'<i8'", "'|O'", "'|b1'", "[('x', '<f8')]", "'<c16'", "''"})
        EXPECT_EQ(refusal(file_text(rays_header(descr), numbers(12))), "F141") << descr;
}

TEST_F(RayFiles, InColumnsAreRefused) {
    EXPECT_EQ(refusal(file_text(rays_header("'<f8'", "(2, 6)", "True"), numbers(12))), "F142");
    EXPECT_EQ(refusal(file_text(rays_header("'<f8'", "(1, 6)", "True"), numbers(6))), "none");
}

TEST_F(RayFiles, OfAnotherShapeAreRefused) {
    for (const char* shape : {"()", "(12,)", "(2, 5)", "(2, 8)", "(1, 2, 6)", "(6, 2)", "(2, 0)"})
        EXPECT_EQ(refusal(file_text(rays_header("'<f8'", shape), numbers(12))), "F143") << shape;
    for (const char* shape : {"(-2, 6)", "(2, 6", "2, 6)", "(2.0, 6)", "(99999999999999999999, 6)", "(2 6)", "(,)"})
        EXPECT_EQ(refusal(file_text(rays_header("'<f8'", shape), numbers(12))), "F140") << shape;
}

TEST_F(RayFiles, OfAnotherLengthAreRefused) {
    const std::string whole = file_text(rays_header(), numbers(12));
    EXPECT_EQ(refusal(whole), "none");
    EXPECT_EQ(refusal(whole.substr(0, whole.size() - 1)), "F144");
    EXPECT_EQ(refusal(whole + "x"), "F144");
    EXPECT_EQ(refusal(file_text(rays_header("'<f8'", "(4611686018427387904, 6)"), numbers(12))), "F144");
    EXPECT_EQ(refusal(file_text(rays_header("'<f8'", "(9223372036854775000, 7)"), "")), "F144");
}

TEST_F(RayFiles, CutOffAnywhereAreRefused) {
    const std::string whole = file_text(rays_header(), numbers(12));
    for (std::size_t size = 0; size < whole.size(); ++size) EXPECT_NE(refusal(whole.substr(0, size)), "none") << size;
}

TEST_F(RayFiles, ThatAreSomethingElseAreRefused) {
    EXPECT_EQ(refusal(""), "F140");
    EXPECT_EQ(refusal("PK\x03\x04 an archive"), "F140");
    EXPECT_EQ(refusal("0 0 0 1 0 0\n"), "F140");
    EXPECT_EQ(refusal(file_text(rays_header(), numbers(12), 4)), "F140");
    std::string huge = file_text(rays_header(), numbers(12), 2);
    huge[11] = '\x7f';
    EXPECT_EQ(refusal(huge), "F140");
    for (const char* header :
         {"", "{}", "{'descr': '<f8'}", "{'descr': '<f8', 'descr': '<f8', 'fortran_order': False, 'shape': (2, 6)}",
          "{'descr': '<f8', 'fortran_order': Maybe, 'shape': (2, 6)}", "{'descr: (2, 6)}", "{'other': 1}",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 6)} and more", "__import__('os')"})
        EXPECT_EQ(refusal(file_text(header, numbers(12))), "F140") << header;
    EXPECT_THROW(RayFile("/nowhere/rays.npy"), IoError);
    EXPECT_THROW(RayFile("/tmp"), IoError);
}

// Every byte of a header replaced by others: read, or refused, never anything else.
TEST_F(RayFiles, WithDamagedHeadersAreReadOrRefused) {
    std::mt19937 random(5);
    const std::string whole = file_text(rays_header(), numbers(12));
    int read = 0, refused = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string head = whole.substr(0, whole.size() - 96);
        for (unsigned k = 0; k <= random() % 3; ++k) head[random() % head.size()] = char(random() % 256);
        head.resize(head.size() - random() % 2 * (random() % head.size()));
        try {
            (void)parse_npy_header(head, "rays.npy");
            ++read;
        } catch (const InputError& error) {
            ASSERT_EQ(error.code, "F140");
            ++refused;
        }
    }
    EXPECT_GT(read, 100);
    EXPECT_GT(refused, 10000);
}

TEST(WrittenArrays, AreReadAgain) {
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "out.npy";
    const std::vector<NpyField> number = {{"", "<f8"}};
    NpyWriter writer(path, number, 8);
    const std::vector<double> values = {1, 2, 3, 4};
    writer.write(2, std::as_bytes(std::span(values).subspan(2)));
    writer.write(0, std::as_bytes(std::span(values).first(2)));
    writer.finish(4);
    std::ifstream stream(path, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    const NpyHeader header = parse_npy_header(text, path.string());
    EXPECT_EQ(header.descr, "<f8");
    EXPECT_FALSE(header.is_fortran);
    EXPECT_EQ(header.shape, (std::vector<std::uint64_t>{4}));
    EXPECT_EQ(header.data_offset % 64, 0u);
    ASSERT_EQ(text.size(), header.data_offset + 32);
    EXPECT_EQ(std::memcmp(text.data() + header.data_offset, values.data(), 32), 0);
}

}  // namespace
}  // namespace enfilade::tools
