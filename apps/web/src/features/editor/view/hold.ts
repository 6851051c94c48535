// Blockly's own menu comes a little later.
const holding = 600
/** Px that a finger may tremble. */
const slop = 8

/** Tells what a press is on when it lasts for a while and stays where it is. */
export function watchHold({ target, clientX, clientY }: PointerEvent, held: (target: Element) => void): void {
  if (!(target instanceof Element)) return
  const away = new AbortController()
  const timer = setTimeout(() => {
    away.abort()
    held(target)
  }, holding)
  const end = () => {
    clearTimeout(timer)
    away.abort()
  }
  const move = (to: PointerEvent) => {
    if (Math.hypot(to.clientX - clientX, to.clientY - clientY) > slop) end()
  }
  const options = { capture: true, signal: away.signal }
  window.addEventListener('pointermove', move, options)
  window.addEventListener('pointerup', end, options)
  window.addEventListener('pointercancel', end, options)
}
