/**
 * Runs `work` and measures it. `seconds`: processor time of this thread. Other programs on the machine do not add to it,
 * as they do to the time on the clock.
 */
export function timed<Result>(work: () => Result): { readonly result: Result; readonly seconds: number } {
  const before = process.threadCpuUsage()
  const result = work()
  const { user, system } = process.threadCpuUsage(before)
  return { result, seconds: (user + system) / 1e6 }
}
