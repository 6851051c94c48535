// Learns beside the page, so that the page stays awake.
import { sleep, type Asked } from './sleep.ts'

self.onmessage = ({ data }: MessageEvent<Asked>) =>
  sleep(
    data,
    (report) => self.postMessage(report),
    () => performance.now(),
  )
