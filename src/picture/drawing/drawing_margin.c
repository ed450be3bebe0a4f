// Draws the machine's name, and a bar that gives the scale in the file's unit of length.
#include "picture/drawing/drawing.h"
#include "picture/svg.h"

// Returns the largest of 1, 2, 5 times a power of ten that is at most `most`.
static double round_down(double most)
{
    double power = yk_pow(10, floor(yk_log10(most)));
    if (5 * power <= most) return 5 * power;
    if (2 * power <= most) return 2 * power;
    return power;
}

static void add_scale(YkDrawing *drawing)
{
    double unit = 1;
    const char *name = yk_model_unit(drawing->model, YK_QUANTITY_LENGTH, &unit);
    double most = 0.2 * drawing->width / drawing->scale / unit;
    if (!isfinite(most) || most <= 1e-300) return;
    double length = round_down(most), pixels = length * unit * drawing->scale, y = drawing->height - 22;
    static const char thin[] = "stroke=\"#55585c\" stroke-width=\"1.2\"";
    yk_svg_line(&drawing->svg, yk_vec(20, y), yk_vec(20 + pixels, y), thin);
    yk_svg_line(&drawing->svg, yk_vec(20, y - 4), yk_vec(20, y + 4), thin);
    yk_svg_line(&drawing->svg, yk_vec(20 + pixels, y - 4), yk_vec(20 + pixels, y + 4), thin);
    YkText words = {0};
    yk_text_format(&words, "%e %s", length, name);
    yk_svg_word(&drawing->svg, yk_vec(28 + pixels, y + 4), yk_text_get(&words), "fill=\"#55585c\" font-size=\"12\"");
    yk_text_free(&words);
}

void yk_drawing_margin(YkDrawing *drawing)
{
    if (!drawing->options.labels) return;
    yk_svg_word(&drawing->svg, yk_vec(20, 30), yk_model_name(drawing->model),
                "fill=\"#1c1e21\" font-size=\"16\" font-weight=\"bold\"");
    if (drawing->pose_count > 0) add_scale(drawing);
}
