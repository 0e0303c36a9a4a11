// Results that are charts (report/chart), as a picture or as a page.
#pragma once

#include "graze/report/chart/charts.hpp"
#include "graze/report/page/detail/page.hpp"
#include "graze/report/page/detail/page_chart.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {

template <class Record>
void draw_chart_or_page(const PictureRequest& request, const Record& record) {
  if (is_page_name(request.file))
    write_page(request.file, record);
  else
    draw_chart(request, record.info, chart_of(record));
}

// One of several charts of a record.
template <class Record>
void draw_chart_or_page(const PictureRequest& request, const Record& record, const Chart& chart) {
  if (is_page_name(request.file))
    write_page(request.file, chart, record.info, record.outcome, record.warnings);
  else
    draw_chart(request, record.info, chart);
}

}  // namespace graze
