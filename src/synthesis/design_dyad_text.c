// Writes the link and the arm of a machine with a dyad, and the gears between the cranks of a five-bar.
#include "synthesis/design_writer.h"
#include "synthesis/paths/path_chain.h"

static const char *const bodies[] = {"ground", "input", "coupler", "output"};

static bool has_dyad(const YkDesign *design)
{
    return yk_bar_size(design->kind) > YK_BAR_PLAIN;
}

static YkChainBody carrier_of(const YkDesign *design, int which)
{
    YkChainVariant variant = yk_chain_variant(design->kind, design->variant);
    return which == 0 ? variant.link : variant.arm;
}

// The point at which link (0) or arm (1) begins: C and D, or the ends of a five-bar's cranks.
static const char *point_name(const YkDesign *design, int which)
{
    if (design->kind != YK_DESIGN_GEARED) return which == 0 ? "C" : "D";
    return carrier_of(design, which) == YK_CHAIN_INPUT ? "A" : "B";
}

void yk_write_dyad_parameters(const YkDesignWriter *w, const YkDesign *design)
{
    if (!has_dyad(design)) return;
    if (design->kind != YK_DESIGN_GEARED) {
        yk_write_length(w, ", cx: ", design->end[0].x);
        yk_write_length(w, ", cy: ", design->end[0].y);
        yk_write_length(w, ", dx: ", design->end[1].x);
        yk_write_length(w, ", dy: ", design->end[1].y);
    }
    yk_write_length(w, ", l: ", design->dyad_length[0]);
    yk_write_length(w, ", m: ", design->dyad_length[1]);
}

void yk_write_dyad_points(const YkDesignWriter *w, const YkDesign *design, int body)
{
    if (!has_dyad(design) || design->kind == YK_DESIGN_GEARED) return;
    if ((int)carrier_of(design, 0) == body) yk_text_puts(w->text, ", C: [cx, cy]");
    if ((int)carrier_of(design, 1) == body) yk_text_puts(w->text, ", D: [dx, dy]");
}

void yk_write_dyad_bodies(const YkDesignWriter *w, const YkDesign *design)
{
    if (!has_dyad(design)) return;
    YkVec mark = yk_add(design->point, yk_vec(design->dyad_length[0] / 4, 0));
    yk_text_format(w->text, "  link: {points: {%s: [0, 0], E: [l, 0], P: [px, py]", point_name(design, 0));
    yk_write_length(w, ", Q: [", mark.x);
    yk_write_length(w, ", ", mark.y);
    yk_text_format(w->text, "]}}\n  arm: {points: {%s: [0, 0], E: [m, 0]}}\n", point_name(design, 1));
}

void yk_write_dyad_joints(const YkDesignWriter *w, const YkDesign *design)
{
    static const char *const links[] = {"link", "arm"}, *const angles[] = {"chi", "omega"};
    if (!has_dyad(design)) return;
    for (int k = 0; k < 2; k++)
        yk_text_format(w->text, "  %s: {pin: [%s, %s], angle: %s}\n", point_name(design, k),
                       bodies[carrier_of(design, k)], links[k], angles[k]);
    yk_text_puts(w->text, "  E: {pin: [link, arm]}\n");
    if (design->kind != YK_DESIGN_GEARED) return;
    int ratio = yk_chain_variant(design->kind, design->variant).ratio;
    if (ratio < 0) {
        yk_text_format(w->text, "gears: {G: {mesh: [input, output], teeth: [%d, 30]}}\n", -30 * ratio);
        return;
    }
    yk_write_length(w, "belts: {G: {between: [input, output], radii: [", 0.1 * ratio * design->length[0]);
    yk_write_length(w, ", ", 0.1 * design->length[0]);
    yk_text_puts(w->text, "]}}\n");
}

void yk_write_dyad_start(const YkDesignWriter *w, const YkDesign *design)
{
    static const char *const words[] = {", chi: ", ", omega: "};
    if (!has_dyad(design)) return;
    for (int k = 0; k < 2; k++) {
        YkChainBody body = carrier_of(design, k);
        double carrier = 0;
        if (body == YK_CHAIN_GROUND) { // the ground's own axes are the world's
            yk_write_angle(w, words[k], design->dyad_angle[k], "");
            continue;
        }
        carrier = design->angle[body - 1];
        yk_write_angle(w, words[k], yk_remainder(design->dyad_angle[k] - carrier, 2 * YK_PI), "");
    }
}
