/** Where something lies and how much room it takes. */
export interface Box {
  readonly left: number
  readonly top: number
  readonly width: number
  readonly height: number
}

const besideEachOther = (a: Box, b: Box) => a.left >= b.left + b.width || b.left >= a.left + a.width

/**
 * The tops of the boxes after each has moved down as little as keeps it off those before it. What lies on nothing stays;
 * what had to move keeps `gap` to what it lay on.
 */
export function partedTops(boxes: readonly Box[], gap: number): readonly number[] {
  const placed: Box[] = []
  return boxes.map((box) => {
    let { top } = box
    // From above to below: what the box has passed it does not meet again.
    for (const other of placed) {
      if (other.top >= top + box.height) break
      if (other.top + other.height <= top || besideEachOther(box, other)) continue
      top = Math.ceil(other.top + other.height + gap)
    }
    const below = placed.findIndex((other) => other.top > top)
    placed.splice(below < 0 ? placed.length : below, 0, { ...box, top })
    return top
  })
}
