#include "svg_text.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

std::string pixels(double value) {
    std::string text;
    append_pixels(text, value);
    return text;
}

TEST(SvgText, PixelsAreShortAndAlwaysNumbers) {
    EXPECT_EQ(pixels(0), "0");
    EXPECT_EQ(pixels(-0.001), "0");
    EXPECT_EQ(pixels(12), "12");
    EXPECT_EQ(pixels(3.5), "3.5");
    EXPECT_EQ(pixels(3.05), "3.05");
    EXPECT_EQ(pixels(-0.07), "-0.07");
    EXPECT_EQ(pixels(1.999), "2");
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(pixels(infinity), "1000000");
    EXPECT_EQ(pixels(-infinity), "-1000000");
    EXPECT_EQ(pixels(std::numeric_limits<double>::quiet_NaN()), "0");
}

TEST(SvgText, PlacesAreParted) {
    std::string text = "M";
    append_place(text, 1, 2);
    append_place(text, 3, 4);
    EXPECT_EQ(text, "M1 2 3 4");
    std::string attribute;
    append_attribute(attribute, "cx", 2.25);
    EXPECT_EQ(attribute, " cx=\"2.25\"");
}

TEST(SvgText, MarksAreEscapedAndWhatXmlForbidsIsReplaced) {
    EXPECT_EQ(xml_text("a < b & c > d"), "a &lt; b &amp; c &gt; d");
    EXPECT_EQ(xml_text("\xcf\x89 \xe2\x82\xac \xf0\x9f\x90\x84"),
              "\xcf\x89 \xe2\x82\xac \xf0\x9f\x90\x84");
    EXPECT_EQ(xml_text(std::string_view("\0\x01\x1b\t", 4)), "???\t");
    EXPECT_EQ(xml_text("\xff-\xc3"), "?-?");          // no lead byte, a sequence cut short
    EXPECT_EQ(xml_text("\xc0\xaf"), "??");            // a '/' in more bytes than it needs
    EXPECT_EQ(xml_text("\xed\xa0\x80"), "???");       // a surrogate
    EXPECT_EQ(xml_text("\xef\xbf\xbf"), "???");       // U+FFFF
    EXPECT_EQ(xml_text("\xf4\x90\x80\x80"), "????");  // beyond the last character
    EXPECT_EQ(xml_text("\xc3<"), "?&lt;");
}

}  // namespace
}  // namespace tightflip::geometry
