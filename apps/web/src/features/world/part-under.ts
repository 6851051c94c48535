const reach = 14

/** The part of a drawing (its `data-part`) nearest to a point of the window, not further than a fingertip; else null. */
export function partUnder(drawing: Element, { clientX, clientY }: PointerEvent): string | null {
  let found: { readonly part: string; readonly away: number } | null = null
  for (const shape of drawing.querySelectorAll('[data-part]')) {
    const { left, right, top, bottom } = shape.getBoundingClientRect()
    const away = Math.hypot(clientX - (left + right) / 2, clientY - (top + bottom) / 2)
    if (away <= reach + (right - left) / 2 && away < (found?.away ?? Infinity))
      found = { part: shape.getAttribute('data-part') ?? '', away }
  }
  return found?.part ?? null
}
