#pragma once
// Texts of a DXF file: from its code page to UTF-8, and without the codes that format them.

#include <string>
#include <string_view>

namespace enfilade::plans::dxf {

/// Reads the bytes of names and texts. Before AC1021 they are written in the code page that $DWGCODEPAGE names
/// (ANSI_1252 where it is absent), since then in UTF-8; "\U+00DC" stands for any character in both.
class Words {
public:
    Words() = default;
    ~Words();
    Words(const Words&) = delete;
    Words& operator=(const Words&) = delete;

    /// As $ACADVER has it ("AC1015").
    void set_version(std::string_view version);
    /// As $DWGCODEPAGE has it. False where that page is not known: ANSI_1252 is taken.
    bool set_code_page(std::string_view name);

    [[nodiscard]] std::string utf8(std::string_view bytes);

private:
    std::string converted(std::string_view bytes);
    void close();

    bool utf8_ = false;
    std::string page_ = "CP1252";
    void* converter_ = nullptr;  ///< an iconv_t
};

/// At most so many bytes of a UTF-8 text, whole letters, with dots where something is cut: for sentences.
[[nodiscard]] std::string shortened(const std::string& text, std::size_t most = 100);

/// Of a TEXT: "%%d" and its like are characters, underlines are taken out.
[[nodiscard]] std::string plain_text(std::string_view text);

/// Of an MTEXT: fonts, heights, colours and braces are taken out, paragraphs and columns become lines, stacked
/// fractions are written with a slash.
[[nodiscard]] std::string plain_mtext(std::string_view text);

}  // namespace enfilade::plans::dxf
