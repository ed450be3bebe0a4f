// The choice among the printers of pages.
#include "page/print.h"
#include <string.h>

static const char *const names[YK_PAGE_FORMATS] = {"text", "latex", "mathml", "json", "c"};

YkPageFormat yk_page_format_find(const char *name)
{
    size_t format = 0;
    while (format < YK_PAGE_FORMATS && strcmp(names[format], name) != 0) format++;
    return (YkPageFormat)format;
}

// A printer of a format that comes in parts.
typedef struct Printer {
    void (*head)(YkPrinting *printing);
    void (*part)(YkPrinting *printing, const YkPage *part);
    void (*end)(YkPrinting *printing);
} Printer;
static const Printer printers[YK_PAGE_FORMATS] = {
    [YK_PAGE_TEXT] = {yk_print_text_head, yk_print_text_part, yk_print_text_end},
    [YK_PAGE_LATEX] = {yk_print_latex_head, yk_print_latex_part, yk_print_latex_end},
    [YK_PAGE_MATHML] = {yk_print_mathml_head, yk_print_mathml_part, yk_print_mathml_end},
    [YK_PAGE_JSON] = {yk_print_json_head, yk_print_json_part, yk_print_json_end},
};

bool yk_page_has_parts(YkPageFormat format)
{
    return format < YK_PAGE_FORMATS && printers[format].part;
}

bool yk_page_add_part(YkPrinting *printing, const YkPage *part)
{
    const Printer *printer = &printers[printing->format];
    if (part->failed) return false;
    if (!printing->has_begun) printer->head(printing);
    printing->has_begun = true;
    if (!printing->failed) printer->part(printing, part);
    return !printing->failed && !printing->text->failed;
}

bool yk_page_end_parts(YkPrinting *printing)
{
    if (printing->has_begun) printers[printing->format].end(printing);
    printing->has_begun = false;
    return !printing->failed && !printing->text->failed;
}

bool yk_page_write(const YkPage *page, YkPageFormat format, const char *title, const double *values, YkText *text)
{
    YkPrinting printing = {.ring = page->ring, .text = text, .values = values, .title = title, .format = format};
    if (page->failed || format >= YK_PAGE_FORMATS) return false;
    if (!yk_page_has_parts(format)) {
        yk_print_c(&printing, page);
        return !printing.failed && !text->failed;
    }
    bool good = yk_page_add_part(&printing, page);
    return yk_page_end_parts(&printing) && good;
}
