#include "report_page.hpp"

#include "command_runner.hpp"
#include <tightflip/geometry/data_sets.hpp>
#include <tightflip/geometry/optimise.hpp>
#include <tightflip/geometry/surface_measures.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/file_error.hpp>
#include <tightflip/kernel/random.hpp>

#include <cmath>
#include <cstring>
#include <numeric>

namespace tightflip::tools {
namespace {

using geometry::Edge;
using geometry::EdgeShape;
using geometry::Index;
using geometry::Surface;
using geometry::Triangulation;
using kernel::FileError;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A start, flips that improve it, and the energy on the way.
struct Optimised {
    Surface before;
    std::vector<Edge> flips;
    ReportSeries series;
};

/// Flips at random first, refused ones among them, so that parallel and folded edges come about.
Optimised run_from(Surface surface, int random_flips) {
    kernel::RandomStream random(1);
    const auto edges = static_cast<std::uint32_t>(surface.triangulation().edge_count());
    for (int i = 0; i < random_flips; ++i)
        (void)surface.triangulation().flip({static_cast<Index>(random.below(edges))});
    Optimised run{surface, {}, {"tight", {}, {}}};
    const auto criterion = make_criterion(geometry::CriterionKind::tight, surface.view());
    run.series.flips.push_back(0);
    run.series.values.push_back(criterion->value().first());
    geometry::OptimiseOptions options;
    options.keep_going = [&](std::int64_t flips, const geometry::Energy& energy) {
        run.series.flips.push_back(flips);
        run.series.values.push_back(energy.first());
        return true;
    };
    run.flips = optimise(surface.triangulation(), surface.points(), *criterion, options).flips;
    return run;
}

OptimisationReport report_of(const Optimised& run) {
    return {"A title", {{"criterion", "tight"}}, run.before, run.flips, {run.series}};
}

Triangulation after(const Optimised& run, std::size_t flips) {
    Triangulation surface = run.before.triangulation();
    surface.flip_all(std::span(run.flips).first(flips));
    return surface;
}

std::vector<Index> next_of(const Triangulation& surface) {
    std::vector<Index> ids;
    for (const auto& record : surface.table())
        ids.push_back(record.next.id);
    return ids;
}

std::vector<Index> origins_of(const Triangulation& surface) {
    std::vector<Index> ids;
    for (const auto& record : surface.table())
        ids.push_back(record.origin.id);
    return ids;
}

std::array<Index, 5> shapes_of(const Optimised& run, std::size_t flips) {
    const Triangulation surface = after(run, flips);
    return measure(geometry::SurfaceView{surface.table(), run.before.points()}).edge_shapes;
}

class ReportPage : public CommandTest {
protected:
    void SetUp() override {
        if (!can_write_report()) GTEST_SKIP() << how_to_get_reports;
    }
    void write_page(const OptimisationReport& report, const ReportLimits& limits = {}) const {
        write_report(path("report"), report, limits);
    }
    /// The page's data as a browser would cut them out.
    [[nodiscard]] Json data() const {
        const std::string page = read("report/index.html");
        const std::string_view begin = "id=\"data\">";
        const std::size_t from = page.find(begin) + begin.size();
        return Json::parse(page.substr(from, page.find("</script", from) - from));
    }
    /// Opens the page in a browser and evaluates the body of a function there, which returns what
    /// is asked about or a promise of it; fails on any complaint of the browser.
    [[nodiscard]] Json in_browser(const std::string& body,
                                  const std::vector<std::string>& flags = {},
                                  int width = 1280) const;

    /// A handful of flips.
    static const Optimised& prism() {
        static const Optimised run = run_from(geometry::data_sets::twisted_prism(3), 0);
        return run;
    }
    /// Many, from a start with folded and parallel edges.
    static const Optimised& sphere() {
        static const Optimised run = run_from(geometry::data_sets::bumpy_sphere(60, 1), 400);
        return run;
    }
};

Json ReportPage::in_browser(const std::string& body, const std::vector<std::string>& flags,
                            int width) const {
    std::string page = read("report/index.html");
    // Frames come by a clock, for nothing is shown; what is printed has no character that the dump
    // would escape.
    const std::string script =
        "<script>"
        "window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), 16);"
        "window.cancelAnimationFrame = clearTimeout;"
        "window.complaints = [];"
        "addEventListener('error', (e) => complaints.push('error: ' + e.message));"
        "addEventListener('securitypolicyviolation', (e) => complaints.push(e.blockedURI));"
        "addEventListener('load', async () => {"
        "  const page = () => window.tightflipReport;"
        "  const result = await (async () => {" +
        body +
        "  })().catch((error) => { complaints.push(String(error)); return null; });"
        "  const loaded = performance.getEntriesByType('resource').length;"
        "  parent.postMessage(JSON.stringify({ result, complaints, loaded })"
        "    .replace(/[&<>\\u0080-\\uffff]/g,"
        "      (c) => '\\\\u' + c.charCodeAt(0).toString(16).padStart(4, '0')), '*');"
        "});"
        "</script>";
    page.insert(page.find("<link"), script);
    write("report/asked.html", page);
    write("report/frame.html", "<body><iframe src='asked.html' width='" + std::to_string(width) +
                                   "' height='900'></iframe><script>"
                                   "addEventListener('message', (e) => { document.body.innerHTML ="
                                   " '<pre>RESULT' + e.data + 'END</pre>'; });</script>");
    std::vector<std::string> arguments{"--headless",
                                       "--no-sandbox",
                                       "--disable-quic",
                                       "--no-first-run",
                                       "--disable-background-networking",
                                       "--disable-component-update",
                                       "--disable-sync",
                                       "--disable-dev-shm-usage",
                                       "--use-angle=swiftshader",
                                       "--enable-unsafe-swiftshader",
                                       "--user-data-dir=" + path("profile").string(),
                                       "--enable-logging=stderr",
                                       "--window-size=1400,1000",
                                       "--virtual-time-budget=9000",
                                       "--dump-dom"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    arguments.push_back("file://" + path("report/frame.html").string());
    const Outcome outcome = run(arguments, {.executable = TIGHTFLIP_CHROMIUM});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, Not(HasSubstr(":CONSOLE"))) << "the browser complained";
    const std::size_t begin = outcome.out.find("RESULT{");
    const std::size_t end = outcome.out.rfind("END</pre>");
    if (begin == std::string::npos || end == std::string::npos) {
        ADD_FAILURE() << "no result\n" << outcome.err << outcome.out.substr(0, 2000);
        return {};
    }
    const Json json = Json::parse(outcome.out.substr(begin + 6, end - begin - 6));
    EXPECT_THAT(json["complaints"], IsEmpty());
    EXPECT_EQ(json["loaded"], 0) << "the page asked for other files";
    return json["result"];
}

TEST_F(ReportPage, IsOneFileThatLoadsNothing) {
    write_page(report_of(prism()));
    const std::string page = read("report/index.html");
    EXPECT_THAT(page, HasSubstr("<title>A title</title>"));
    EXPECT_THAT(page,
                HasSubstr("content=\"default-src 'none'; script-src 'unsafe-inline'; style-src "
                          "'unsafe-inline'; img-src data:\""));
    for (const char* place : {"{{title}}", "{{data}}", "{{style}}", "{{libraries}}", "{{script}}"})
        EXPECT_THAT(page, Not(HasSubstr(place)));
    EXPECT_THAT(page, Not(HasSubstr("<script src")));
    EXPECT_EQ(names().count("report"), 1U);
}

TEST_F(ReportPage, SaysWhatTheRunWas) {
    write_page(report_of(sphere()));
    const Json json = data();
    EXPECT_EQ(json["vertices"], 60);
    EXPECT_EQ(json["edges"], 174);
    EXPECT_EQ(json["faces"], 116);
    EXPECT_EQ(json["genus"], 0);
    EXPECT_EQ(json["flips"], sphere().flips.size());
    EXPECT_EQ(json["facts"][0], Json({"criterion", "tight"}));
    EXPECT_EQ(json["shapesBefore"], Json(shapes_of(sphere(), 0)));
    EXPECT_EQ(json["shapesAfter"], Json(shapes_of(sphere(), sphere().flips.size())));
    EXPECT_GT(json["shapesBefore"][static_cast<std::size_t>(EdgeShape::folded)], 0);
    EXPECT_EQ(json["series"][0]["flips"], Json(sphere().series.flips));
    EXPECT_EQ(json["series"][0]["values"], Json(sphere().series.values));
}

TEST_F(ReportPage, NoWordsBreakOutOfIt) {
    const std::string nasty = "</title></script><script>alert(1)</script><!-- &amp; \xff {{data}}";
    OptimisationReport report = report_of(prism());
    report.title = nasty;
    report.facts = {{nasty, nasty}};
    report.series[0].name = nasty;
    write_page(report);
    const std::string mended =
        "</title></script><script>alert(1)</script><!-- &amp; \xef\xbf\xbd {{data}}";
    const Json json = data();
    EXPECT_EQ(json["facts"][0], Json({mended, mended}));
    EXPECT_EQ(json["series"][0]["name"], mended);
    const std::string page = read("report/index.html");
    EXPECT_THAT(page, HasSubstr("<title>&lt;/title&gt;&lt;/script&gt;&lt;script&gt;alert(1)"
                                "&lt;/script&gt;&lt;!-- &amp;amp; \xff {{data}}</title>"));
    EXPECT_THAT(page, Not(HasSubstr("alert(1)</script>")));
}

TEST_F(ReportPage, LongSeriesKeepEndsAndExtremes) {
    OptimisationReport report = report_of(prism());
    ReportSeries& series = report.series[0];
    series = {"waves", std::vector<std::int64_t>(100'000), std::vector<double>(100'000)};
    std::iota(series.flips.begin(), series.flips.end(), 0);
    for (std::size_t i = 0; i < series.values.size(); ++i)
        series.values[i] = std::sin(static_cast<double>(i));
    series.values[77'777] = 9;
    series.values[33'333] = -9;
    series.values[50'000] = std::nan("");
    write_page(report);
    const Json json = data()["series"][0];
    const auto flips = json["flips"].get<std::vector<std::int64_t>>();
    ASSERT_EQ(flips.size(), json["values"].size());
    EXPECT_LE(flips.size(), 2'002U);
    EXPECT_GE(flips.size(), 1'900U);
    EXPECT_EQ(flips.front(), 0);
    EXPECT_EQ(flips.back(), 99'999);
    EXPECT_TRUE(std::is_sorted(flips.begin(), flips.end(), std::less_equal<>()));
    EXPECT_THAT(flips, ::testing::IsSupersetOf({33'333, 77'777}));
    for (std::size_t i = 0; i < flips.size(); ++i) {
        const double value = series.values[static_cast<std::size_t>(flips[i])];
        EXPECT_EQ(json["values"][i], std::isfinite(value) ? Json(value) : Json());
    }
}

/// The numbers behind a text in base 64.
std::vector<float> floats_of(const std::string& text) {
    const std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 255U);
    }
    std::vector<float> numbers(bytes.size() / sizeof(float));
    std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(float));
    return numbers;
}

TEST_F(ReportPage, PointsOfAnySizeAndPlaceAreInTheUnitBall) {
    const auto points_of = [&](const auto& moved) {
        Optimised run = prism();
        std::vector<geometry::Point> points;
        for (const geometry::Point& p : prism().before.points())
            points.push_back(moved(p));
        run.before = Surface(run.before.triangulation(), points);
        write_page(report_of(run));
        return floats_of(data()["points"]);
    };
    using geometry::Point;
    const auto plain = points_of([](const Point& p) { return p; });
    ASSERT_EQ(plain.size(), 27U);
    float farthest = 0;
    for (std::size_t i = 0; i < plain.size(); i += 3)
        farthest = std::max(farthest, std::hypot(plain[i], plain[i + 1], plain[i + 2]));
    EXPECT_NEAR(farthest, 1, 1e-6);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        float least = 2;
        float greatest = -2;
        for (std::size_t i = axis; i < plain.size(); i += 3) {
            least = std::min(least, plain[i]);
            greatest = std::max(greatest, plain[i]);
        }
        EXPECT_NEAR(least, -greatest, 1e-6);
    }
    // One shape whatever its size and place.
    const Point& p0 = prism().before.point({0});
    const Point& p1 = prism().before.point({1});
    const double scale = (plain[3] - plain[0]) / (p1.x() - p0.x());
    EXPECT_NEAR(plain[5] - plain[2], scale * (p1.z() - p0.z()), 1e-6);
    const auto near_plain = ::testing::Pointwise(::testing::FloatNear(1e-5F), plain);
    EXPECT_THAT(points_of([](const Point& p) -> Point { return 1e307 * p; }), near_plain);
    EXPECT_THAT(points_of([](const Point& p) -> Point { return 1e-300 * p; }), near_plain);
    EXPECT_THAT(points_of([](const Point& p) -> Point { return p + Point::Constant(1e6); }),
                near_plain);
    EXPECT_THAT(points_of([](const Point&) -> Point { return Point::Zero(); }), Each(0.0F));
}

TEST_F(ReportPage, LimitsSayHowMuchIsKept) {
    const std::size_t flips = sphere().flips.size();
    ASSERT_GT(flips, 50U);
    write_page(report_of(sphere()), {.flips = flips});
    EXPECT_EQ(data()["frames"].size(), 1U);
    EXPECT_TRUE(data().contains("steps"));

    const auto kept = [&](const ReportLimits& limits) {
        write_page(report_of(sphere()), limits);
        EXPECT_FALSE(data().contains("steps"));
        std::vector<std::size_t> places;
        const Json frames = data()["frames"];
        for (const Json& frame : frames)
            places.push_back(frame["at"]);
        return places;
    };
    EXPECT_THAT(kept({.flips = flips - 1, .surfaces = 4}),
                ElementsAre(0U, flips / 3, 2 * flips / 3, flips));
    EXPECT_THAT(kept({.flips = 0, .halfedges = 3 * 348}), ElementsAre(0U, flips / 2, flips));
    EXPECT_THAT(kept({.flips = 0, .halfedges = 0}), ElementsAre(0U, flips));
    EXPECT_THAT(kept({.vertices = 59}), IsEmpty());
    EXPECT_FALSE(data().contains("points"));
    EXPECT_EQ(data()["shapesAfter"], Json(shapes_of(sphere(), flips)));
}

TEST_F(ReportPage, MisuseAndDisksAreReported) {
    Optimised run = prism();
    run.flips.push_back({21});
    EXPECT_THROW(write_page(report_of(run)), std::out_of_range);
    run.flips = {Edge{-1}};
    EXPECT_THROW(write_page(report_of(run)), std::out_of_range);
    // Of a book's edges to its leaves none can be flipped.
    const Triangulation book = kernel::families::book(5);
    run.before = Surface(book, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
    Edge refused{0};
    while (book.can_flip(refused))
        ++refused.id;
    run.flips = {refused};
    EXPECT_THROW(write_page(report_of(run)), std::invalid_argument);
    EXPECT_THAT(names(), IsEmpty());

    write("report", "a file in the way");
    EXPECT_THROW(write_page(report_of(prism())), FileError);
    EXPECT_EQ(read("report"), "a file in the way");
}

/// The same in a browser.
class ReportInBrowser : public ReportPage {
protected:
    void SetUp() override {
        ReportPage::SetUp();
        if (IsSkipped()) return;
        if (std::string_view(TIGHTFLIP_CHROMIUM).empty()) {
            GTEST_SKIP()
                << "no chromium was there when the tests were built: install it, build again";
        }
    }
    static constexpr const char* table =
        "const table = () => { const { table } = page().sequence;"
        "  return { next: [...table.next], origin: [...table.origin], counts: [...table.counts],"
        "           shapes: [...table.shapes], position: page().sequence.position }; };";
};

void expect_state(const Json& state, const Optimised& run, std::size_t flips) {
    SCOPED_TRACE("after " + std::to_string(flips) + " flips");
    const Triangulation surface = after(run, flips);
    EXPECT_EQ(state["position"], flips);
    EXPECT_EQ(state["next"], Json(next_of(surface)));
    EXPECT_EQ(state["origin"], Json(origins_of(surface)));
    EXPECT_EQ(state["counts"], Json(shapes_of(run, flips)));
    for (Index e = 0; e < surface.edge_count(); ++e) {
        const auto shape =
            edge_shape(geometry::SurfaceView{surface.table(), run.before.points()}, Edge{e});
        EXPECT_EQ(state["shapes"][static_cast<std::size_t>(e)], static_cast<int>(shape)) << e;
    }
}

TEST_F(ReportInBrowser, ReplaysAsTheKernelDoes) {
    const Optimised& run = sphere();
    const std::size_t flips = run.flips.size();
    write_page(report_of(run));
    const std::vector<std::size_t> positions{flips, 0, 1, flips / 2, flips / 2 + 1, 7, flips};
    const Json states =
        in_browser(std::string(table) +
                   "const states = { replay: document.body.dataset.replay, at: [] };"
                   "for (const position of " +
                   Json(positions).dump() +
                   ") {"
                   "  page().show(position); states.at.push(table()); } return states;");
    EXPECT_EQ(states["replay"], "equal");
    ASSERT_EQ(states["at"].size(), positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
        expect_state(states["at"][i], run, positions[i]);
}

TEST_F(ReportInBrowser, SurfacesOnTheWayAreTheKernelsToo) {
    const Optimised& run = sphere();
    write_page(report_of(run), {.flips = 1, .surfaces = 5});
    const Json result = in_browser(
        std::string(table) +
        "const at = [];"
        "for (const i of [4, 0, 2]) { page().show(i); const { flips } = document.body.dataset;"
        "  at.push({ ...table(), position: Number(flips) }); }"
        "const flips = page().data.flips;"
        "const asked = [0, Math.floor(flips / 4) - 1, Math.floor(flips / 4), flips - 1, flips];"
        "return { at, replay: document.body.dataset.replay,"
        "         positions: asked.map((n) => page().sequence.positionAt(n)),"
        "         note: document.getElementById('thinned').textContent };");
    EXPECT_EQ(result["replay"], "equal");
    EXPECT_THAT(result["note"].get<std::string>(), HasSubstr("goes over 5 surfaces"));
    EXPECT_EQ(result["positions"], Json({0, 0, 1, 3, 4})) << "the last that is not beyond";
    expect_state(result["at"][0], run, run.flips.size());
    expect_state(result["at"][1], run, 0);
    expect_state(result["at"][2], run, run.flips.size() / 2);
}

TEST_F(ReportInBrowser, SliderKeysPlayAndAddressSteer) {
    write_page(report_of(prism()));
    const Json json = in_browser(
        "const at = () => [page().sequence.position, "
        "document.getElementById('position').textContent,"
        "                  document.getElementById('slider').value].join('|');"
        "const key = (key, shiftKey) => document.body.dispatchEvent("
        "    new KeyboardEvent('keydown', { key, shiftKey, bubbles: true }));"
        "const seen = [at()];"
        "key('ArrowLeft'); seen.push(at());"
        "key('ArrowLeft', true); seen.push(at());"
        "key('ArrowRight'); seen.push(at());"
        "key('End'); seen.push(at()); key('ArrowRight'); seen.push(at());"
        "const slider = document.getElementById('slider');"
        "slider.value = 3; slider.dispatchEvent(new Event('input')); seen.push(at());"
        "location.hash = '#flip=5'; await new Promise((go) => setTimeout(go, 100)); "
        "seen.push(at());"
        "key('Home'); seen.push(at());"
        "const later = (seconds) => new Promise((go) => setTimeout(go, 1000 * seconds));"
        "key(' '); const label = document.getElementById('play').getAttribute('aria-label');"
        "await later(1); key('ArrowRight');"
        "const stopped = page().sequence.position; await later(1);"
        "const stays = page().sequence.position === stopped && stopped > 1 && stopped < 9;"
        "key(' '); await later(6); seen.push(at());"
        "return { seen, label, stays };");
    EXPECT_THAT(
        json["seen"].get<std::vector<std::string>>(),
        ElementsAre("9|9 / 9 flips|9", "8|8 / 9 flips|8", "0|0 / 9 flips|0", "1|1 / 9 flips|1",
                    "9|9 / 9 flips|9", "9|9 / 9 flips|9", "3|3 / 9 flips|3", "5|5 / 9 flips|5",
                    "0|0 / 9 flips|0", "9|9 / 9 flips|9"));
    EXPECT_EQ(json["label"], "Pause");
    EXPECT_EQ(json["stays"], true) << "a step ends playing";
}

/// Reads a half of the canvas, or a plot, as pixels.
constexpr const char* pixels =
    "const pixels = (canvas, left, right) => {"
    "  const copy = document.createElement('canvas');"
    "  copy.width = canvas.width; copy.height = canvas.height;"
    "  const context = copy.getContext('2d');"
    "  context.drawImage(canvas, 0, 0);"
    "  const x = Math.round(left * copy.width), width = Math.round((right - left) * copy.width);"
    "  return new Uint32Array(context.getImageData(x, 0, width, copy.height).data.buffer); };"
    "const colours = (some) => new Set(some).size;"
    "const differing = (a, b) => a.reduce((n, pixel, i) => n + (pixel !== b[i]), 0);";

TEST_F(ReportInBrowser, DrawsStartAndPresentSurface) {
    write_page(report_of(prism()));
    const Json json =
        in_browser(std::string(pixels) +
                   "const canvas = document.getElementById('space');"
                   "const drawn = (half) => { page().space.render(); return pixels(canvas, half / "
                   "2, half / 2 + 0.5); };"
                   "const end = [drawn(0), drawn(1)];"
                   "page().show(0); const start = [drawn(0), drawn(1)];"
                   "page().show(4); const middle = drawn(1);"
                   "page().show(0); const again = drawn(1);"
                   "page().space.camera.position.set(0, -4.4, 0); page().space.controls.update();"
                   "return { colours: colours(start[1]), sides: differing(start[0], start[1]),"
                   "  left: differing(start[0], end[0]), right: differing(start[1], end[1]),"
                   "  middle: differing(start[1], middle), again: differing(start[1], again),"
                   "  turned: differing(start[1], drawn(1)), all: start[1].length };");
    EXPECT_GT(json["colours"], 50) << "shaded faces and smoothed edges";
    EXPECT_EQ(json["sides"], 0) << "at the start both views show the same";
    EXPECT_EQ(json["left"], 0) << "the start stays";
    EXPECT_GT(json["right"], 1000);
    EXPECT_GT(json["middle"], 1000);
    EXPECT_EQ(json["again"], 0);
    EXPECT_GT(json["turned"], 1000);
    EXPECT_LT(json["right"], json["all"]);
}

TEST_F(ReportInBrowser, DraggingTurnsAndOptionsChangeThePicture) {
    write_page(report_of(sphere()));
    const Json json = in_browser(
        std::string(pixels) +
        "const canvas = document.getElementById('space');"
        "const drawn = () => { page().space.render(); return pixels(canvas, 0, 1); };"
        "const mouse = (target, type, x, y) => target.dispatchEvent("
        "    new MouseEvent(type, { button: 0, clientX: x, clientY: y, bubbles: true }));"
        "const before = drawn();"
        "mouse(canvas, 'mousedown', 300, 300); mouse(document, 'mousemove', 400, 330);"
        "mouse(document, 'mouseup', 400, 330); const turned = drawn();"
        "document.getElementById('reset').click(); const back = drawn();"
        "document.getElementById('see-through').click(); const through = drawn();"
        "document.getElementById('see-through').click();"
        "document.getElementById('all-edges').click(); const fewer = drawn();"
        "document.getElementById('all-edges').click(); const same = drawn();"
        "return [turned, back, through, fewer, same].map((some) => differing(before, some));");
    ASSERT_EQ(json.size(), 5U);
    EXPECT_GT(json[0], 1000) << "dragged";
    EXPECT_LT(json[1], 100) << "reset";
    EXPECT_GT(json[2], 1000) << "see through";
    EXPECT_GT(json[3], 1000) << "fewer edges";
    EXPECT_LT(json[4], 100) << "all edges again";
}

TEST_F(ReportInBrowser, PlotsAndTablesAreThere) {
    OptimisationReport report = report_of(prism());
    report.series.push_back({"mean", {0, 9}, {5, 4}});
    report.facts.emplace_back("<b>", "</script>");
    report.title = "<i>a & b</i>";
    write_page(report);
    const Json json = in_browser(
        std::string(pixels) +
        "const cells = (id) => [...document.querySelectorAll(`#${id} tr`)].map((row) =>"
        "    [...row.cells].map((cell) => cell.textContent));"
        "page().show(5);"
        "const inks = () => page().charts.map((chart) => colours(pixels(chart.canvas, 0, 1)));"
        "const linear = page().charts.map((chart) => chart.scales.y.type), ink = inks();"
        "const { canvas, scales } = page().charts[0], box = canvas.getBoundingClientRect();"
        "canvas.dispatchEvent(new MouseEvent('click', { bubbles: true,"
        "  clientX: box.left + scales.x.getPixelForValue(7), clientY: box.top + 50 }));"
        "await new Promise((go) => setTimeout(go, 100));"
        "const clicked = page().sequence.position;"
        "page().show(5); document.getElementById('log-scale').click();"
        "return { clicked, title: document.title, heading: "
        "document.getElementById('title').textContent, "
        "ink, linear,"
        "  logarithmic: page().charts.map((chart) => chart.scales.y.type),"
        "  headings: [...document.querySelectorAll('.plot h2')].map((node) => node.textContent),"
        "  concave: page().charts[2].data.datasets[0].data.map((point) => point.y),"
        "  edges: cells('edges'), facts: cells('facts'),"
        "  problem: document.getElementById('problem').hidden };");
    EXPECT_EQ(json["title"], "<i>a & b</i>");
    EXPECT_EQ(json["clicked"], 7) << "a click on a plot";
    EXPECT_EQ(json["heading"], "<i>a & b</i>");
    EXPECT_EQ(json["headings"], Json({"tight", "mean", "concave edges"}));
    EXPECT_THAT(json["ink"].get<std::vector<int>>(), Each(::testing::Gt(20)));
    EXPECT_EQ(json["linear"], Json({"linear", "linear", "linear"}));
    // The concave edges end at none, which has no logarithm.
    EXPECT_EQ(json["logarithmic"], Json({"logarithmic", "logarithmic", "linear"}));
    EXPECT_EQ(json["facts"], Json::array({{"criterion", "tight"}, {"<b>", "</script>"}}));
    std::vector<Index> concave;
    for (std::size_t flips = 0; flips <= prism().flips.size(); ++flips)
        concave.push_back(shapes_of(prism(), flips)[1]);
    EXPECT_EQ(json["concave"], Json(concave));
    ASSERT_EQ(json["edges"].size(), 6U);
    EXPECT_EQ(json["edges"][0], Json({"shape", "start", "shown", "end"}));
    const auto count = [&](std::size_t flips) {
        return std::to_string(shapes_of(prism(), flips)[1]);
    };
    EXPECT_EQ(json["edges"][2], Json({"concave", count(0), count(5), count(9)}));
    EXPECT_EQ(json["problem"], true);
}

TEST_F(ReportInBrowser, WithoutWebGlTheRestIsThere) {
    write_page(report_of(prism()));
    const Json json =
        in_browser(std::string(table) +
                       "page().show(4);"
                       "return { ...table(), note: document.getElementById('no-space').textContent,"
                       "  shown: !document.getElementById('no-space').hidden, stage: "
                       "document.getElementById('stage').hidden,"
                       "  space: page().space, charts: page().charts.length };",
                   {"--disable-3d-apis"});
    EXPECT_EQ(json["space"], Json());
    EXPECT_EQ(json["shown"], true);
    EXPECT_EQ(json["stage"], true);
    EXPECT_THAT(json["note"].get<std::string>(), HasSubstr("no WebGL"));
    EXPECT_EQ(json["charts"], 2);
    expect_state(json, prism(), 4);
}

TEST_F(ReportInBrowser, TooLargeASurfaceLeavesPlotsAndTables) {
    write_page(report_of(prism()), {.vertices = 8});
    const Json json = in_browser(
        "return { note: document.getElementById('no-space').textContent,"
        "  charts: page().charts.length, rows: document.querySelectorAll('#edges tr').length,"
        "  player: document.getElementById('player').hidden };");
    EXPECT_THAT(json["note"].get<std::string>(), HasSubstr("9 vertices are too many"));
    EXPECT_EQ(json["charts"], 1);
    EXPECT_EQ(json["rows"], 6);
    EXPECT_EQ(json["player"], true);
}

TEST_F(ReportInBrowser, ADamagedFileSaysSo) {
    write_page(report_of(prism()));
    std::string page = read("report/index.html");
    const std::string sum = data()["checksum"];
    const std::size_t place = page.find(sum);
    ASSERT_NE(place, std::string::npos);
    page[place] = page[place] == '0' ? '1' : '0';
    write("report/index.html", page);
    const Json json = in_browser(
        "return { replay: document.body.dataset.replay, problem: "
        "document.getElementById('problem').hidden };");
    EXPECT_EQ(json["replay"], "different");
    EXPECT_EQ(json["problem"], false);
}

TEST_F(ReportInBrowser, NothingToDoIsShownToo) {
    Optimised run = prism();
    run.flips.clear();
    run.series = {"tight", {0}, {12.5}};
    write_page(report_of(run));
    const Json json = in_browser(
        "return { position: document.getElementById('position').textContent,"
        "  play: document.getElementById('play').disabled, replay: document.body.dataset.replay "
        "};");
    EXPECT_EQ(json["position"], "0 / 0 flips");
    EXPECT_EQ(json["play"], true);
    EXPECT_EQ(json["replay"], "equal");
}

TEST_F(ReportInBrowser, FitsAPhone) {
    write_page(report_of(sphere()));
    const Json json = in_browser(
        "page().space.render();"
        "return { inner: innerWidth, content: document.documentElement.scrollWidth,"
        "  rectangles: page().space.rectangles, stage: "
        "document.getElementById('stage').clientWidth };",
        {}, 360);
    EXPECT_EQ(json["inner"], 360);
    EXPECT_LE(json["content"], 360);
    EXPECT_GT(json["stage"], 300);
    EXPECT_EQ(json["rectangles"][0][2], json["stage"]) << "one above the other";
}

}  // namespace
}  // namespace tightflip::tools
