#include "script_watch.hpp"

#include "nth.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/surface_equality.hpp>
#include <tightflip/properties/invariants.hpp>

#include <algorithm>

namespace tightflip::properties {
namespace {

/// The kernel, what is known of it, and this library's kernel beside it.
class ScriptWatch {
public:
    /// `tell` hears of findings as they are made.
    ScriptWatch(const KernelDescription& kernel, const Triangulation& start,
                std::function<void(const KernelFinding&)> tell)
        : kernel_(kernel), start_(start), tell_(std::move(tell)), log_{start, {}} {}

    ScriptRun run(std::span<const Edge> script, bool laws) {
        try {
            if (begin()) follow(script, laws);
        } catch (const std::exception& error) {
            add(KernelCode::threw, error.what());
        } catch (...) {
            add(KernelCode::threw, "something that is no std::exception");
        }
        for (KernelFinding& finding : run_.findings) {
            finding.script.assign(script.begin(),
                                  script.begin() + static_cast<std::ptrdiff_t>(
                                                       std::min(finding.step, script.size())));
        }
        return std::move(run_);
    }

private:
    void add(KernelCode code, std::string words) {
        if (std::ranges::find(run_.findings, code, &KernelFinding::code) != run_.findings.end()) {
            return;
        }
        run_.findings.push_back({.code = code,
                                 .start = {},
                                 .step = step_,
                                 .words = std::move(words),
                                 .script = {},
                                 .log = log_});
        if (tell_) tell_(run_.findings.back());
    }

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
        side_at_ = *image;
        our_side_.resize(side_at_.size());
        for (std::size_t h = 0; h < side_at_.size(); ++h)
            nth(our_side_, side_at_[h]) = static_cast<Index>(h);
        judge_counts();
        judge_validator(judgement);
        return true;
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
        if (says_valid == judgement.is_valid()) return;
        if (says_valid) {
            add(KernelCode::invalid_accepted, "its validator passes this: " + judgement.fault);
        } else {
            add(KernelCode::valid_rejected, "its validator rejects a surface that is valid");
        }
    }

    // ---- the flips ----

    void follow(std::span<const Edge> script, bool laws) {
        for (const Edge e : script) {
            ++step_;
            const Index side = nth(side_at_, halfedge_of(e).id);
            if (!answer_is_right(side)) continue;
            const SideTables before = tables_;
            Index turned = side;  // a side of the flipped edge after the flip
            if (!flip_and_judge(side, turned)) return;
            if (laws && !obeys_laws(before, side, turned)) return;
        }
    }

    /// The kernel's yes, after it was judged.
    bool answer_is_right(Index side) {
        SideTables expected = tables_;
        const bool defined = flip_by_definition(expected, side);
        const std::string fault =
            defined ? judge(expected, kernel_.allowed).fault : "one face has both its sides";
        const bool yes = mesh_->can_flip(side);
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

    /// False where following makes no sense any more.
    bool flip_and_judge(Index side, Index& turned) {
        const SideTables before = tables_;
        const auto around = sides_around(before, side);
        SideTables expected = before;
        flip_by_definition(expected, side);
        flip_ours(side);
        mesh_->flip(side);
        if (!read()) return false;
        const Judgement judgement = judge(tables_, kernel_.allowed);
        judge_validator(judgement);
        judge_counts();
        if (around) {
            judge_locality(before, *around);
            const auto image = image_of(expected, *around);
            if (!image) {
                add(KernelCode::not_the_flip, "edge " + edge_in_words(before, side) +
                                                  " was flipped, and the two faces are not those "
                                                  "of the diagonal flip");
            } else {
                turned = nth(*image, side);
                judge_handles(*image, *around);
            }
            if (ours_) judge_agreement(before, *around);
        }
        judge_topology(judgement);
        return around && judgement.is_valid();
    }

    void judge_topology(const Judgement& judgement) {
        kernel::Topology now = judgement.topology;
        if (now.faces == 0) return;                              // not even faces
        if (!judgement.is_valid()) now.genus = topology_.genus;  // has none
        const std::vector<Violation> changed = changes(topology_, now);
        if (!changed.empty()) add(KernelCode::topology_changed, message(changed.front()));
    }

    void flip_ours(Index side) {
        if (!ours_) return;
        const Edge e = our_edge(side);
        log_.flips.push_back(e);
        if (!ours_->flip(e)) ours_.reset();  // beyond our class
    }

    void judge_locality(const SideTables& before, const std::array<Index, 6>& around) {
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

    /// Where the sides of the expected tables are in the kernel now.
    std::optional<std::vector<Index>> image_of(const SideTables& expected,
                                               const std::array<Index, 6>& around) const {
        for (Index s = 0; s < expected.size(); ++s) {
            if (std::ranges::find(around, s) == around.end()) {
                return isomorphism(expected, s, tables_, s);
            }
        }
        for (const Index s : around) {  // there are no other faces
            if (auto image = isomorphism(expected, around[0], tables_, s)) return image;
        }
        return std::nullopt;
    }

    void judge_handles(const std::vector<Index>& image, const std::array<Index, 6>& around) {
        if (!kernel_.keeps_sides) return;
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

    void judge_agreement(const SideTables& before, const std::array<Index, 6>& around) {
        const SideTables ours = side_tables(*ours_);
        std::optional<std::vector<Index>> image;
        const auto outside = [&](Index s) { return std::ranges::find(around, s) == around.end(); };
        for (Index s = 0; s < before.size() && !image; ++s) {
            if (outside(s)) {
                image = isomorphism(ours, nth(our_side_, s), tables_, s);
                break;
            }
        }
        if (!image && before.size() == 6) {
            for (Index s = 0; s < before.size() && !image; ++s)
                image = isomorphism(ours, 0, tables_, s);
        }
        if (!image) {
            add(KernelCode::surface_differs_from_ours,
                "after the same flips this library's kernel has another surface");
            ours_.reset();
            return;
        }
        for (std::size_t h = 0; h < image->size(); ++h)
            nth(our_side_, (*image)[h]) = static_cast<Index>(h);
    }

    // ---- the laws ----

    /// Flips three times more, which must give the old sides, and then once again.
    bool obeys_laws(const SideTables& before, Index side, Index turned) {
        const SideTables once = tables_;
        for (int n = 2; n <= 5; ++n) {
            if (!mesh_->can_flip(turned)) {
                add(KernelCode::flip_back_refused,
                    "the edge just flipped may not be flipped again");
                return false;
            }
            if (!flip_and_judge(turned, turned)) return false;
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
    std::function<void(const KernelFinding&)> tell_;
    kernel::FlipLog log_;
    ScriptRun run_;
    std::size_t step_ = 0;  // flips attempted
    std::unique_ptr<KernelUnderTest> mesh_;
    SideTables tables_;  // of the mesh, as it is now
    kernel::Topology topology_;
    std::optional<Triangulation> ours_;  // empty once the script has left our class
    std::vector<Index> side_at_;         // the kernel's side at each halfedge of the start
    std::vector<Index> our_side_;        // our halfedge at each side of the kernel, now
};

}  // namespace

ScriptRun watch_script(const KernelDescription& kernel, const Triangulation& start,
                       std::span<const Edge> script, bool laws,
                       std::function<void(const KernelFinding&)> tell) {
    return ScriptWatch(kernel, start, std::move(tell)).run(script, laws);
}

}  // namespace tightflip::properties
