#include "bench/report/page.hpp"

#include "bench/report/page/bench_page_axis.hpp"
#include "bench/report/page/bench_page_charts.hpp"
#include "bench/report/page/bench_page_css.hpp"
#include "bench/report/page/bench_page_growth.hpp"
#include "bench/report/page/bench_page_html.hpp"
#include "bench/report/page/bench_page_images.hpp"
#include "bench/report/page/bench_page_kernels.hpp"
#include "bench/report/page/bench_page_plot.hpp"
#include "bench/report/page/bench_page_run.hpp"
#include "bench/report/page/bench_page_text.hpp"
#include "core/report/page_parts.hpp"

#include <ostream>

namespace raylab::bench {

void write_page(std::ostream& out, const Json& report) {
  const auto [head, after_style] = split(bench_page_html, "{{style}}");
  const auto [markup, after_data] = split(after_style, "{{data}}");
  const auto [start, end] = split(after_data, "{{script}}");
  out << head << bench_page_css << markup;
  out << "<script type=\"application/json\" id=\"report\">" << script_json(report) << "</script>" << start;
  // One module: what a part declares, those after it use.
  out << bench_page_text << bench_page_axis << bench_page_plot << bench_page_charts << bench_page_images
      << bench_page_kernels << bench_page_growth << bench_page_run << end;
}

}  // namespace raylab::bench
