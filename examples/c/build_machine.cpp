// Makes a slider-crank by calls, solves a pose, and writes the machine as a model file.
//   c++ build_machine.cpp $(pkg-config --cflags --libs yoke) && ./a.out slider-crank.yaml
#include <cstdio>
#include <initializer_list>
#include <memory>
#include <yoke/yoke.h>

template <class T, void (*release)(T *)> struct Release {
    void operator()(T *object) const { release(object); }
};
template <class T, void (*release)(T *)> using Owned = std::unique_ptr<T, Release<T, release>>;

int main(int argc, char **argv)
{
    Owned<YkProblems, yk_problems_free> problems(yk_problems_new());
    Owned<YkBuilder, yk_builder_free> b(yk_builder_new("Slider-crank"));
    if (!problems || !b) return 2;
    for (const char *body : {"crank", "rod", "piston"}) yk_builder_body(b.get(), body);
    for (const char *body : {"ground", "crank"}) yk_builder_point(b.get(), body, "O", 0, 0);
    yk_builder_point(b.get(), "crank", "A", 0.3, 0);
    yk_builder_point(b.get(), "rod", "A", 0, 0);
    yk_builder_point(b.get(), "rod", "B", 0.5, 0);
    yk_builder_point(b.get(), "piston", "B", 0, 0);
    yk_builder_pin(b.get(), "O", "ground", "crank", nullptr, "theta");
    yk_builder_pin(b.get(), "A", "crank", "rod", nullptr, "phi");
    yk_builder_pin(b.get(), "B", "rod", "piston", nullptr, nullptr);
    yk_builder_slide(b.get(), "S", "ground", "piston", "x", nullptr, nullptr, "s");
    yk_builder_drive(b.get(), "theta", "90 deg + 60 rpm * t");
    yk_builder_start(b.get(), "s", 0.4);
    Owned<YkModel, yk_model_free> model(yk_builder_model(b.get(), nullptr, problems.get()));
    Owned<YkMechanism, yk_mechanism_free> mech(
        model ? yk_mechanism_compile(model.get(), nullptr, problems.get()) : nullptr);
    Owned<YkState, yk_state_free> state(mech ? yk_state_new(mech.get()) : nullptr);
    bool good = state && yk_state_set_time(state.get(), 0, problems.get()) >= 0 && yk_state_assemble(state.get()) >= 0;
    if (good) std::printf("s = %g m\n", yk_state_coordinate(state.get(), yk_coordinate_find(mech.get(), "s")).position);
    if (good && argc > 1) good = yk_model_write(model.get(), argv[1], problems.get()) == YK_OK;
    std::fputs(yk_problems_text(problems.get(), 0), stderr);
    if (state && !good) std::fprintf(stderr, "%s\n", yk_state_report(state.get())->message); // where it does not close
    return good ? 0 : 2;
}
