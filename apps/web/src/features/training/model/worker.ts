// Practises beside the page, so that nothing on the screen waits for it.
import { realTime } from './around.ts'
import { Host } from './host.ts'
import type { Order, Report } from './messages.ts'

const post = (report: Report) => {
  if (report.kind === 'answer') return self.postMessage(report)
  const owned = report.kind === 'progress' ? [report.now.buffer, report.stored.buffer] : [report.now.buffer]
  self.postMessage(report, { transfer: owned })
}

const host = new Host({ ...realTime(), post, slice: 8 })
self.onmessage = ({ data }: MessageEvent<Order>) => host.take(data)
