#include "script_watch.hpp"

#include "nth.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/surface_equality.hpp>
#include <tightflip/properties/child_process.hpp>
#include <tightflip/properties/invariants.hpp>

#include <algorithm>
#include <numeric>

namespace tightflip::properties {
namespace {

/// The kernel, what is known of it, and this library's kernel beside it.
class ScriptWatch {
public:
    ScriptWatch(const KernelDescription& kernel, const Triangulation& start,
                std::span<const Edge> script, bool laws, std::function<void(const ScriptRun&)> tell)
        : kernel_(kernel), start_(start), script_(script), laws_(laws), tell_(std::move(tell)) {}

    ScriptRun run() {
        const auto thrown = thrown_by([&] {
            if (begin()) follow();
        });
        if (thrown) add(KernelCode::threw, *thrown);
        if (tell_) tell_(run_);
        return std::move(run_);
    }

private:
    void add(KernelCode code, std::string words) {
        if (std::ranges::find(run_.findings, code, &KernelFinding::code) != run_.findings.end()) {
            return;
        }
        run_.findings.push_back(finding_at(code, std::move(words), run_, start_, script_, laws_));
        if (tell_) tell_(run_);
    }

    /// The property is being put to the test.
    void ask(KernelProperty property) { ++run_.asked[static_cast<std::size_t>(property)]; }

    // ---- the start ----

    bool begin() {
        mesh_ = kernel_.make(gluing_of(start_));
        if (!read()) return false;
        const Judgement judgement = judge(tables_, kernel_.allowed);
        if (!judgement.is_valid()) {
            add(KernelCode::start_differs, judgement.fault);
            return false;
        }
        const SideReading reading = read_as_gluing(tables_);
        auto ours = kernel::build(reading.gluing);
        if (!ours || !same_labelled_surface(*ours.triangulation, start_)) {
            add(KernelCode::start_differs, "it is not the surface that the kernel was given");
            return false;
        }
        topology_ = judgement.topology;
        ours_ = start_;
        const SideTables given = side_tables(start_);
        Index anchor = 0;
        std::optional<std::vector<Index>> image;  // the kernel's side at each of our halfedges
        while (!image && anchor < tables_.size())
            image = isomorphism(given, 0, tables_, anchor++);
        our_side_.resize(image->size());
        match(*image);
        ask(KernelProperty::reading);
        judge_counts();
        judge_validator(judgement);
        return true;
    }

    /// The kernel's sides have these places among ours.
    void match(const std::vector<Index>& side_at) {
        side_at_ = side_at;
        for (std::size_t h = 0; h < side_at.size(); ++h)
            nth(our_side_, side_at[h]) = static_cast<Index>(h);
    }

    static Gluing gluing_of(const Triangulation& surface) {
        return read_as_gluing(side_tables(surface)).gluing;
    }

    bool read() {
        tables_ = mesh_->tables();
        const auto known = [](const std::vector<Index>& entries) {
            return std::ranges::find(entries, -1) == entries.end();
        };
        if (known(tables_.next) && known(tables_.across) &&
            mesh_->side_count() == tables_.next.size()) {
            return true;
        }
        add(KernelCode::sides_unreadable, "it names or lists sides that it did not list before");
        return false;
    }

    void judge_counts() {
        const std::array<Index, 3> counts = mesh_->counts();
        const std::array<Index, 3> right{topology_.vertices, topology_.edges, topology_.faces};
        if (counts == right) return;
        std::string words = "it counts";
        for (const Index count : counts)
            words += " " + std::to_string(count);
        words += " vertices, edges and faces where there are";
        for (const Index count : right)
            words += " " + std::to_string(count);
        add(KernelCode::counts_differ, words);
    }

    void judge_validator(const Judgement& judgement) {
        const bool says_valid = mesh_->is_valid();
        if (!judgement.is_valid()) ask(KernelProperty::validator);
        if (says_valid == judgement.is_valid()) return;
        if (says_valid) {
            add(KernelCode::invalid_accepted, "its validator passes this: " + judgement.fault);
        } else {
            add(KernelCode::valid_rejected, "its validator rejects a surface that is valid");
        }
    }

    // ---- the flips ----

    void follow() {
        for (const Edge e : script_) {
            ++run_.step;
            const Index side = nth(side_at_, halfedge_of(e).id);
            if (!judged_answer(side)) {
                if (ours_) run_.flips.pop_back();
                continue;
            }
            const SideTables before = tables_;
            Index turned = side;  // a side of the flipped edge after the flip
            if (!flip_and_judge(side, turned)) return;
            if (laws_ && !obeys_laws(before, side, turned)) return;
        }
    }

    /// The kernel's yes or no. From here on the log ends in this edge.
    bool answer(Index side) {
        if (ours_) run_.flips.push_back(our_edge(side));
        if (tell_) tell_(run_);
        return mesh_->can_flip(side);
    }

    bool judged_answer(Index side) {
        SideTables expected = tables_;
        const bool defined = flip_by_definition(expected, side);
        const std::string fault =
            defined ? judge(expected, kernel_.allowed).fault : "one face has both its sides";
        const bool yes = answer(side);
        ask(KernelProperty::legality);
        const std::string edge = edge_in_words(side);
        if (yes && !fault.empty()) {
            add(KernelCode::invalid_flip_allowed,
                "it says that edge " + edge + " may be flipped: " + fault);
        }
        if (!yes && fault.empty()) {
            add(KernelCode::valid_flip_refused,
                "it refuses edge " + edge + ", whose flip is valid");
        }
        // A simple kernel has more to refuse than ours, and one with loops less.
        if (ours_ && kernel_.allowed == KernelClass::loopless &&
            yes != static_cast<bool>(ours_->can_flip(our_edge(side)))) {
            add(KernelCode::answers_differ_from_ours,
                std::string("it says ") + (yes ? "yes" : "no") + " of edge " + edge);
        }
        return yes;
    }

    /// After a yes. False where following makes no sense any more.
    bool flip_and_judge(Index side, Index& turned) {
        const SideTables before = tables_;
        const auto around = sides_around(before, side);
        SideTables expected = before;
        flip_by_definition(expected, side);
        if (ours_ && !ours_->flip(run_.flips.back())) ours_.reset();  // beyond our class
        mesh_->flip(side);
        ask(KernelProperty::survival);
        if (!read()) return false;
        const Judgement judgement = judge(tables_, kernel_.allowed);
        judge_validator(judgement);
        judge_counts();
        if (around) {
            judge_locality(before, *around);
            ask(KernelProperty::definition);
            const auto image = image_of(expected, *around);
            if (!image) {
                add(KernelCode::not_the_flip, "edge " + edge_in_words(before, side) +
                                                  " was flipped, and the two faces are not those "
                                                  "of the diagonal flip");
            } else {
                turned = nth(*image, side);
                judge_handles(*image, *around);
            }
            if (ours_) judge_agreement(*around);
        }
        judge_topology(judgement);
        return around && judgement.is_valid();
    }

    void judge_topology(const Judgement& judgement) {
        kernel::Topology now = judgement.topology;
        if (now.faces == 0) return;  // not even faces
        ask(KernelProperty::topology);
        if (!judgement.is_valid()) now.genus = topology_.genus;  // has none
        const std::vector<Violation> changed = changes(topology_, now);
        if (!changed.empty()) add(KernelCode::topology_changed, message(changed.front()));
    }

    void judge_locality(const SideTables& before, const std::array<Index, 6>& around) {
        ask(KernelProperty::locality);
        const auto inside = [&](Index s) { return std::ranges::find(around, s) != around.end(); };
        for (Index s = 0; s < before.size(); ++s) {
            if (inside(s)) continue;
            const Index across = nth(before.across, s);
            const Index across_now = nth(tables_.across, s);
            const bool kept = nth(before.next, s) == nth(tables_.next, s) &&
                              nth(before.origin, s) == nth(tables_.origin, s) &&
                              (across == across_now || (inside(across) && inside(across_now)));
            if (kept) continue;
            add(KernelCode::changed_elsewhere,
                "side " + std::to_string(s) + " lies in neither face at the edge and changed");
            return;
        }
    }

    /// Where the sides of the expected tables are in the kernel now, when the side s was `names[s]`
    /// there: if it can be, with a side outside the two faces where it was.
    std::optional<std::vector<Index>> image_of(const SideTables& expected,
                                               const std::vector<Index>& names,
                                               const std::array<Index, 6>& around) const {
        const auto image = [&](Index from, Index to) {
            return isomorphism(expected, nth(names, from), tables_, to);
        };
        for (Index s = 0; s < expected.size(); ++s) {
            if (std::ranges::find(around, s) != around.end()) continue;
            if (auto found = image(s, s)) return found;
        }
        for (Index to = 0; to < expected.size(); ++to) {
            if (auto found = image(around[0], to)) return found;
        }
        return std::nullopt;
    }
    std::optional<std::vector<Index>> image_of(const SideTables& expected,
                                               const std::array<Index, 6>& around) const {
        std::vector<Index> same(expected.next.size());
        std::iota(same.begin(), same.end(), 0);
        return image_of(expected, same, around);
    }

    void judge_handles(const std::vector<Index>& image, const std::array<Index, 6>& around) {
        if (!kernel_.keeps_sides) return;
        ask(KernelProperty::handles);
        const auto [s, s1, s2, t, t1, t2] = around;
        for (const Index outer : {s1, s2, t1, t2}) {
            if (nth(image, outer) == outer) continue;
            add(KernelCode::side_moved,
                "side " + std::to_string(outer) + " of another edge now means another side");
        }
        if (nth(image, s) != s && nth(image, s) != t) {
            add(KernelCode::side_moved, "the sides of the edge itself now belong to another edge");
        }
    }

    void judge_agreement(const std::array<Index, 6>& around) {
        ask(KernelProperty::agreement);
        const auto image = image_of(side_tables(*ours_), our_side_, around);
        if (!image) {
            add(KernelCode::surface_differs_from_ours,
                "after the same flips this library's kernel has another surface");
            ours_.reset();
            return;
        }
        match(*image);
    }

    // ---- the laws ----

    /// Flips three times more, which must give the old sides, and then once again.
    bool obeys_laws(const SideTables& before, Index side, Index turned) {
        const SideTables once = tables_;
        for (int n = 2; n <= 5; ++n) {
            if (!answer(turned)) {
                add(KernelCode::flip_back_refused,
                    "the edge just flipped may not be flipped again");
                return false;
            }
            if (!flip_and_judge(turned, turned)) return false;
            if (n == 2) ask(KernelProperty::inverse);
            if (n == 2 && !same_surface(before, side)) {
                add(KernelCode::flip_back_differs, "two flips of one edge change the surface");
                return false;
            }
            if (n == 4 && kernel_.keeps_sides && tables_ != before) {
                add(KernelCode::four_flips_differ,
                    "four flips of one edge do not restore its sides");
                return false;
            }
        }
        return !kernel_.keeps_sides || tables_ == once;
    }

    bool same_surface(const SideTables& before, Index side) const {
        const auto around = sides_around(before, side);
        return around && image_of(before, *around);
    }

    // ---- words ----

    [[nodiscard]] Edge our_edge(Index side) const {
        return edge_of(kernel::Halfedge{nth(our_side_, side)});
    }
    [[nodiscard]] static std::string edge_in_words(const SideTables& tables, Index side) {
        return std::to_string(nth(tables.origin, side)) + "-" +
               std::to_string(nth(tables.origin, nth(tables.across, side)));
    }
    [[nodiscard]] std::string edge_in_words(Index side) const {
        return edge_in_words(tables_, side);
    }

    const KernelDescription& kernel_;
    const Triangulation& start_;
    std::span<const Edge> script_;
    bool laws_;
    std::function<void(const ScriptRun&)> tell_;
    ScriptRun run_;
    std::unique_ptr<KernelUnderTest> mesh_;
    SideTables tables_;  // of the mesh, as it is now
    kernel::Topology topology_;
    std::optional<Triangulation> ours_;  // empty once the script has left our class
    // Now, or when the script left our class:
    std::vector<Index> side_at_;   // the kernel's side at each of our halfedges
    std::vector<Index> our_side_;  // our halfedge at each side of the kernel
};

}  // namespace

ScriptRun watch_script(const KernelDescription& kernel, const Triangulation& start,
                       std::span<const Edge> script, bool laws,
                       std::function<void(const ScriptRun&)> tell) {
    return ScriptWatch(kernel, start, script, laws, std::move(tell)).run();
}

KernelFinding finding_at(KernelCode code, std::string words, const ScriptRun& run,
                         const Triangulation& start, std::span<const Edge> script, bool laws) {
    const auto asked = script.first(std::min(run.step, script.size()));
    return {.code = code,
            .start = {},
            .step = run.step,
            .words = std::move(words),
            .script = FlipScript(asked.begin(), asked.end()),
            .laws = laws,
            .log = kernel::FlipLog{start, run.flips}};
}

}  // namespace tightflip::properties
