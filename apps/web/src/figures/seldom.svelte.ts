/** A value that follows another one: at once after a rest, else so many milliseconds after its last change. */
export function seldom<T>(value: () => T, milliseconds: number): { readonly now: T } {
  let now = $state.raw(value())
  let changedAt = -Infinity
  $effect.pre(() => {
    const next = value()
    const show = () => {
      changedAt = performance.now()
      now = next
    }
    const wait = changedAt + milliseconds - performance.now()
    if (wait <= 0) return show()
    const timer = setTimeout(show, wait)
    return () => clearTimeout(timer)
  })
  return {
    get now() {
      return now
    },
  }
}
