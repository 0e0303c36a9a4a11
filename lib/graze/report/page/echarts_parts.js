// The parts of Apache ECharts that the page uses; what is not named here is not in the page.
import { LineChart, ScatterChart } from 'echarts/charts';
import {
  DataZoomInsideComponent, GridComponent, MarkAreaComponent, MarkLineComponent, TitleComponent,
} from 'echarts/components';
import { init, use } from 'echarts/core';
import { LabelLayout } from 'echarts/features';
import { CanvasRenderer } from 'echarts/renderers';

use([LineChart, ScatterChart, GridComponent, DataZoomInsideComponent, MarkAreaComponent,
  MarkLineComponent, TitleComponent, LabelLayout, CanvasRenderer]);

export { init };

// What all pictures have in common.
export const kCommon = {
  animation: false, backgroundColor: 'transparent',
  textStyle: { fontFamily: 'system-ui, "DejaVu Sans", sans-serif' },
};

// What all axes have in common.
export function axis(colours, name, low, high, more = {}) {
  return {
    type: 'value', name, min: low, max: high, nameLocation: 'middle',
    nameTextStyle: { color: colours.ink, fontSize: 13 },
    axisLine: { show: true, onZero: false, lineStyle: { color: colours.faint } },
    axisTick: { show: true, lineStyle: { color: colours.faint } },
    axisLabel: {
      color: colours.ink, fontSize: 12, hideOverlap: true, showMinLabel: false, showMaxLabel: false,
      formatter: (value) => tick(value),
    },
    splitLine: { show: true, lineStyle: { color: colours.line, width: 0.6, opacity: 0.7 } },
    ...more,
  };
}

// Above the first axes, where what is across is a forcing frequency from `low` to `high`, rad/s.
export function hertzAxis(colours, low, high) {
  return axis(colours, 'forcing frequency (Hz)', low / (2 * Math.PI), high / (2 * Math.PI),
    { gridIndex: 0, position: 'top', nameGap: 28, splitLine: { show: false } });
}

function tick(value) {
  const text = Math.abs(value) > 0 && (Math.abs(value) < 1e-5 || Math.abs(value) >= 1e7)
    ? value.toExponential() : String(Number(value.toPrecision(9)));
  return text.replace('-', '−');
}
