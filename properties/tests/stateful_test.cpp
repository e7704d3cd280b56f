// Triangulation against the reference model under random sequences of everything that can be done
// to it. The model takes part as RapidCheck's model, the kernel as the system under test.

#include <tightflip/kernel/surface_text.hpp>
#include <tightflip/properties/invariants.hpp>
#include <tightflip/properties/rapidcheck.hpp>
#include <tightflip/properties/reference_model.hpp>

#include <sstream>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <rapidcheck/state.h>

namespace tightflip::properties {
namespace {

struct SystemUnderTest {
    explicit SystemUnderTest(const Triangulation& start)
        : topology(audit(start).topology), surface(start), start_of_log(start) {}

    Topology topology;
    Triangulation surface;
    Triangulation start_of_log;  // and the flips since, for replay
    FlipScript log;
};

using Command = rc::state::Command<ReferenceModel, SystemUnderTest>;

/// What every command must leave behind: the surface that the model names, and a sound one.
class Checked : public Command {
public:
    void run(const ReferenceModel& before, SystemUnderTest& system) const final {
        act(before, system);
        RC_ASSERT(nextState(before).difference(system.surface) == std::nullopt);
        RC_ASSERT(first_violation(system.surface, system.topology) == std::nullopt);
    }

private:
    virtual void act(const ReferenceModel& before, SystemUnderTest& system) const = 0;
};

Edge any_edge(const ReferenceModel& model) {
    return {*rc::gen::resize(rc::kNominalSize, rc::gen::inRange<Index>(0, model.edge_count()))};
}

class OnEdge : public Checked {
public:
    explicit OnEdge(const ReferenceModel& model) : edge_(any_edge(model)) {}

protected:
    [[nodiscard]] Edge edge() const { return edge_; }
    void show_with(std::ostream& out, const char* verb) const { out << verb << ' ' << edge_.id; }

private:
    Edge edge_;
};

class Flip : public OnEdge {
public:
    using OnEdge::OnEdge;
    void apply(ReferenceModel& model) const override { model.flip(edge()); }
    void show(std::ostream& out) const override { show_with(out, "flip"); }

private:
    void act(const ReferenceModel& before, SystemUnderTest& system) const override {
        const bool done = static_cast<bool>(system.surface.flip(edge()));
        RC_ASSERT(done == before.can_flip(edge()));
        if (done) system.log.push_back(edge());
    }
};

class Unflip : public OnEdge {
public:
    using OnEdge::OnEdge;
    void apply(ReferenceModel& model) const override { model.unflip(edge()); }
    void show(std::ostream& out) const override { show_with(out, "unflip"); }

private:
    void act(const ReferenceModel& before, SystemUnderTest& system) const override {
        const bool done = static_cast<bool>(system.surface.unflip(edge()));
        RC_ASSERT(done == before.can_flip(edge()));
        if (done) system.log.insert(system.log.end(), 3, edge());  // flip has order 4
    }
};

class CanFlip : public OnEdge {
public:
    using OnEdge::OnEdge;
    void show(std::ostream& out) const override { show_with(out, "can_flip"); }

private:
    void act(const ReferenceModel& before, SystemUnderTest& system) const override {
        RC_ASSERT(static_cast<bool>(system.surface.can_flip(edge())) == before.can_flip(edge()));
    }
};

class FlipAll : public Checked {
public:
    explicit FlipAll(const ReferenceModel& model)
        : edges_(static_cast<std::size_t>(
              *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 60)))) {
        for (Edge& e : edges_)
            e = any_edge(model);
    }
    void apply(ReferenceModel& model) const override {
        for (const Edge e : edges_)
            model.flip(e);
    }
    void show(std::ostream& out) const override {
        out << "flip_all";
        for (const Edge e : edges_)
            out << ' ' << e.id;
    }

private:
    void act(const ReferenceModel& before, SystemUnderTest& system) const override {
        ReferenceModel model = before;
        std::size_t done = 0;
        for (const Edge e : edges_) {
            if (!model.flip(e)) continue;
            ++done;
            system.log.push_back(e);
        }
        RC_ASSERT(system.surface.flip_all(edges_) == done);
    }

    FlipScript edges_;
};

/// A copy is equal and independent; flips of one do not show in the other.
class CopyAndAssign : public OnEdge {
public:
    using OnEdge::OnEdge;
    void show(std::ostream& out) const override { show_with(out, "copy, flip the copy's edge"); }

private:
    void act(const ReferenceModel& before, SystemUnderTest& system) const override {
        Triangulation copy = system.surface;
        RC_ASSERT(copy == system.surface);
        const bool flipped = static_cast<bool>(copy.flip(edge()));
        RC_ASSERT((copy == system.surface) != flipped);
        RC_ASSERT(before.difference(system.surface) == std::nullopt);
        copy = system.surface;
        system.surface = std::move(copy);
    }
};

class ReloadText : public Checked {
public:
    void show(std::ostream& out) const override { out << "write as text and read back"; }

private:
    void act(const ReferenceModel&, SystemUnderTest& system) const override {
        std::ostringstream text;
        write_text(text, system.surface);
        system.surface = build(kernel::parse_surface(text.str(), "text")).value();
    }
};

/// The run so far, written as a log and replayed, takes the surface's place; a new log begins.
class ReplayLog : public Checked {
public:
    void show(std::ostream& out) const override { out << "write the log, replay it"; }

private:
    void act(const ReferenceModel&, SystemUnderTest& system) const override {
        std::ostringstream bytes;
        write_binary(bytes, kernel::FlipLog{system.start_of_log, system.log});
        kernel::Replay replayed = replay(kernel::parse_flip_log(bytes.str(), "log"));
        RC_ASSERT(replayed.is_complete());
        system.surface = std::move(replayed.surface);
        system.start_of_log = system.surface;
        system.log.clear();
    }
};

RC_GTEST_PROP(TriangulationUnderCommands, IsWhatTheReferenceModelSays, ()) {
    const FlipCase start = *any_flip_case({.spare_vertices = 12, .flips = 0});
    SystemUnderTest system(start.start());
    rc::state::check(ReferenceModel(system.surface), system,
                     rc::state::gen::execOneOfWithArgs<Flip, Flip, Unflip, CanFlip, FlipAll,
                                                       CopyAndAssign, ReloadText, ReplayLog>());
}

}  // namespace
}  // namespace tightflip::properties
