// Files of cameras, read beside a scene.

#include "tools/view_file.h"

#include "accel/locate.h"
#include "accel/scene_file.h"
#include "base/error.h"
#include "tests/cli/program.h"
#include "tools/floor_views.h"

namespace enfilade::test {
namespace {

using tools::SavedView;
using tools::ViewFile;

class ViewFiles : public OfficeTest {
protected:
    static void SetUpTestSuite() {
        OfficeTest::SetUpTestSuite();
        scene_ = accel::open(folder() / "office.enf");
    }
    static const accel::SceneView& scene() { return scene_.view(); }

    /// Three views in rooms, as `enfilade tour` would save them.
    static std::vector<SavedView> some_views() {
        std::vector<SavedView> views;
        for (const render::Camera& camera : tools::floor_views(scene(), 3, 1024))
            views.push_back(tools::as_saved({"view " + std::to_string(views.size() + 1), camera, {}}, scene()));
        return views;
    }
    static std::string text_of(const std::string& view) { return R"({"format_version": 1, "views": [)" + view + "]}"; }

    /// The sentence with its place, and the code.
    static std::pair<std::string, std::string> refusal(const std::string& text) {
        try {
            (void)tools::parse_views(text, "tour.json", scene());
        } catch (const InputError& error) {
            return {error.code, error.located()};
        }
        return {};
    }

    static inline accel::Scene scene_;
};

std::array<double, 3> float_eye(const SavedView& view) {
    const render::Vec3f eye = render::vec_cast<float>(view.camera.eye);
    return {eye.x, eye.y, eye.z};
}

TEST_F(ViewFiles, ReadBackWhatWasWritten) {
    const std::vector<SavedView> views = some_views();
    const ViewFile file = tools::parse_views(tools::view_file_text(views, scene()), "tour.json", scene());
    EXPECT_TRUE(file.relocated.empty());
    EXPECT_EQ(file.warning("tour.json"), "");
    ASSERT_EQ(file.views.size(), views.size());
    for (std::size_t k = 0; k < views.size(); ++k) {
        EXPECT_EQ(file.views[k].name, views[k].name);
        EXPECT_EQ(file.views[k].cell, views[k].cell);
        EXPECT_LT(render::length(file.views[k].camera.eye - views[k].camera.eye), 1e-9);
        EXPECT_LT(render::length(file.views[k].camera.target - views[k].camera.target), 1e-9);
        EXPECT_TRUE(accel::contains(scene(), file.views[k].cell, float_eye(file.views[k])));
    }
    EXPECT_EQ(tools::view_file_text(file.views, scene()), tools::view_file_text(views, scene()));
}

TEST_F(ViewFiles, AStaleCellIsLookedForAnewAndNamed) {
    std::vector<SavedView> views = some_views();
    const accel::CellId right = views[1].cell;
    views[1].cell = accel::CellId(index(right) == 0 ? 1 : index(right) - 1);
    views[2].cell = accel::CellId(4000000000u);
    const ViewFile file = tools::parse_views(tools::view_file_text(views, scene()), "tour.json", scene());
    EXPECT_EQ(file.relocated, (std::vector<std::string>{views[1].name, views[2].name}));
    EXPECT_EQ(file.views[1].cell, right);
    EXPECT_TRUE(accel::contains(scene(), file.views[2].cell, float_eye(file.views[2])));
    EXPECT_NE(file.warning("tour.json").find("2 views of 3 stand in another cell"), std::string::npos)
        << file.warning("tour.json");
}

TEST_F(ViewFiles, AViewWithoutCellIsLocatedInSilence) {
    std::string text = tools::view_file_text(some_views(), scene());
    for (std::size_t at = 0; (at = text.find(", \"cell\": ", at)) != std::string::npos;)
        text.erase(at, text.find('}', at) - at);
    const ViewFile file = tools::parse_views(text, "tour.json", scene());
    EXPECT_TRUE(file.relocated.empty());
    ASSERT_EQ(file.views.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(file.views[k].cell, some_views()[k].cell);
}

TEST_F(ViewFiles, AnEyeOnAPortalStandsInTheOneCellThatHoldsIt) {
    // The middle of the side between two cells, 1 m above their floor.
    for (const accel::Portal& portal : scene().portals) {
        const accel::Cell& cell = scene().cells[index(portal.front)];
        for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
            const std::uint32_t next = s + 1 == cell.first_section + cell.section_count ? cell.first_section : s + 1;
            const std::uint32_t face = scene().section_tails[s].first_face;
            if (!scene().side_faces[face].target.is_portal()) continue;
            SavedView view = some_views()[0];
            view.camera.eye = {(double(scene().section_x[s]) + scene().section_x[next]) / 2,
                               (double(scene().section_y[s]) + scene().section_y[next]) / 2, cell.z_floor + 0.25};
            view.camera.target = view.camera.eye + render::Vec3d{1, 1, 0};
            const SavedView saved = tools::as_saved(view, scene());
            const std::size_t other = index(scene().side_faces[face].target.neighbour());
            EXPECT_TRUE(saved.cell == portal.front || index(saved.cell) == other);
            const ViewFile file =
                tools::parse_views(tools::view_file_text(std::vector{saved}, scene()), "tour.json", scene());
            EXPECT_TRUE(file.relocated.empty());
            EXPECT_EQ(file.views[0].cell, saved.cell);
            return;
        }
    }
    FAIL() << "the office has no doors";
}

TEST_F(ViewFiles, AnEyeInAWallIsNamedWithItsPlace) {
    const auto [code, sentence] = refusal(
        "{\"format_version\": 1, \"views\": [\n"
        "  {\"name\": \"Lost\", \"eye\": [0, 0, -500], \"target\": [1, 0, 0]}]}");
    EXPECT_EQ(code, "F135");
    EXPECT_TRUE(sentence.starts_with("tour.json:2:")) << sentence;
    EXPECT_NE(sentence.find("\"Lost\""), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("enfilade tour"), std::string::npos) << sentence;
}

TEST_F(ViewFiles, RefuseWhatIsNoViewFileWithItsPlace) {
    const std::string good = R"("eye": [1, 1, 1.6], "target": [2, 1, 1.6])";
    const std::vector<std::pair<std::string, std::string>> wrong = {
        {"", "P101"},
        {"not JSON", "P101"},
        {"[]", "P103"},
        {"{}", "P104"},
        {R"({"format_version": 2, "views": []})", "P105"},
        {R"({"format_version": 1})", "P104"},
        {R"({"format_version": 1, "views": []})", "F134"},
        {R"({"format_version": 1, "views": {}})", "P103"},
        {R"({"format_version": 1, "views": [], "colour": 1})", "P102"},
        {text_of("7"), "P103"},
        {text_of(R"({"eye": [1, 1, 1.6]})"), "P104"},
        {text_of(R"({"target": [1, 1, 1.6]})"), "P104"},
        {text_of(R"({"eye": [NaN, 1, 1.6], "target": [2, 1, 1.6]})"), "P101"},
        {text_of(R"({"eye": [1e999, 1, 1.6], "target": [2, 1, 1.6]})"), "P101"},
        {text_of(R"({"eye": [1e30, 1, 1.6], "target": [2, 1, 1.6]})"), "P105"},
        {text_of(R"({"eye": [1, 1], "target": [2, 1, 1.6]})"), "P103"},
        {text_of(R"({"eye": [1, 1, "up"], "target": [2, 1, 1.6]})"), "P103"},
        {text_of("{" + good + R"(, "fov_deg": 180})"), "P105"},
        {text_of("{" + good + R"(, "fov_deg": 0})"), "P105"},
        {text_of("{" + good + R"(, "cell": 1.5})"), "P103"},
        {text_of("{" + good + R"(, "cell": -1})"), "P105"},
        {text_of("{" + good + R"(, "roll": 3})"), "P102"},
        {text_of(R"({"eye": [1, 1, 1.6], "target": [1, 1, 1.6]})"), "F135"},
        {text_of(R"({"eye": [1, 1, 1.6], "target": [1, 1, 9]})"), "F135"},
    };
    for (const auto& [text, code] : wrong) {
        const auto [found, sentence] = refusal(text);
        EXPECT_EQ(found, code) << text << '\n' << sentence;
        EXPECT_TRUE(sentence.starts_with("tour.json:")) << sentence;
    }
}

TEST_F(ViewFiles, RefuseANameUsedTwice) {
    std::vector<SavedView> views = some_views();
    views[2].name = views[0].name;
    const auto [code, sentence] = refusal(tools::view_file_text(views, scene()));
    EXPECT_EQ(code, "F134");
    EXPECT_TRUE(sentence.starts_with("tour.json:6:5: ")) << sentence;
}

TEST_F(ViewFiles, KeepNamesOfAnyText) {
    std::vector<SavedView> views = some_views();
    views[0].name = "Büro \"7\" \\ \n 会議室";
    const ViewFile file = tools::parse_views(tools::view_file_text(views, scene()), "tour.json", scene());
    EXPECT_EQ(file.views[0].name, views[0].name);
}

TEST_F(ViewFiles, CutShortAtAnyPlaceAreRefused) {
    const std::string text = tools::view_file_text(some_views(), scene());
    for (std::size_t size = 0; size + 2 < text.size(); ++size)
        EXPECT_EQ(refusal(text.substr(0, size)).first, "P101") << size;
}

}  // namespace
}  // namespace enfilade::test
