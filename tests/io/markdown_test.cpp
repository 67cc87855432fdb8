#include "io/markdown.hpp"

#include <catch2/catch.hpp>

using namespace osculate;

TEST_CASE("A page's headings, paragraphs, lists and tables become HTML") {
  CHECK(io::html_of_markdown("# Top\n\nTwo\nlines.\n\n- one\n- two\n\n## Below\n", 2) ==
        "<h2>Top</h2>\n<p>Two\nlines.\n</p>\n<ul>\n<li>one\n<li>two\n</ul>\n<h3>Below</h3>\n");
  CHECK(io::html_of_markdown("| a | b |\n|---|---|\n| 1 < 2 | \\|∇Γ\\| |\n", 1) ==
        "<table>\n<tr><th>a</th><th>b</th></tr>\n<tr><td>1 &lt; 2</td><td>|∇Γ|</td></tr>\n</table>\n");
}

TEST_CASE("Code, emphasis and links within a line; asterisks of formulas stay") {
  CHECK(io::html_of_markdown("run `a < b`, see [here](page.md), the *right* one\n", 1) ==
        "<p>run <code>a &lt; b</code>, see here, the <em>right</em> one\n</p>\n");
  CHECK(io::html_of_markdown("F_t*' = F_t* − μ(F_n* − F_n) [KDY23]\n", 1) ==
        "<p>F<sub>t</sub>*' = F<sub>t</sub>* − μ(F<sub>n</sub>* − F<sub>n</sub>) [KDY23]\n</p>\n");
}

TEST_CASE("Formulas in plain text get their indices and powers, and nothing else does") {
  CHECK(io::html_of_formula("4/3 Ê R_vol^½ δ^{3/2} F_{3/2}(h)") ==
        "4/3 Ê R<sub>vol</sub><sup>½</sup> δ<sup>3/2</sup> F<sub>3/2</sub>(h)");
  CHECK(io::html_of_formula("a < b_c, _x, ^ and {y}, end_") == "a &lt; b<sub>c</sub>, _x, ^ and {y}, end_");
  CHECK(io::html_of_markdown("`a_c` is a_c\n", 1) == "<p><code>a_c</code> is a<sub>c</sub>\n</p>\n");
}
