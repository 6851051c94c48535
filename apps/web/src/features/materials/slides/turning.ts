/** So far a finger goes for a turn, in px, and at most this much of it up or down. */
const far = 60
const level = 0.6

/** Tells when a finger or a pen was drawn across an element. */
export const swipes = (swiped: (way: 'left' | 'right') => void) => (place: HTMLElement) => {
  let from: { readonly id: number; readonly x: number; readonly y: number } | null = null
  const down = ({ pointerId: id, pointerType, clientX: x, clientY: y }: PointerEvent) => {
    from = pointerType === 'mouse' ? null : { id, x, y }
  }
  const up = ({ pointerId, clientX, clientY }: PointerEvent) => {
    if (from?.id !== pointerId) return
    const [across, along] = [clientX - from.x, clientY - from.y]
    from = null
    if (Math.abs(across) >= far && Math.abs(along) <= Math.abs(across) * level)
      swiped(across < 0 ? 'left' : 'right')
  }
  place.style.touchAction = 'pan-y pinch-zoom'
  place.addEventListener('pointerdown', down)
  place.addEventListener('pointerup', up)
  return () => {
    place.removeEventListener('pointerdown', down)
    place.removeEventListener('pointerup', up)
  }
}

/** Keeps the windows of a deck on the same slide: the one on the wall and the teacher's own. */
export function together(deck: string, now: () => number, turned: (at: number) => void) {
  const channel = new BroadcastChannel('botgarten-slides')
  channel.onmessage = ({ data }: MessageEvent<{ deck: string; at?: number }>) => {
    if (data.deck !== deck) return
    if (data.at === undefined) channel.postMessage({ deck, at: now() })
    else turned(data.at)
  }
  return {
    /** Where are the others? */
    ask: () => channel.postMessage({ deck }),
    tell: (at: number) => channel.postMessage({ deck, at }),
    close: () => channel.close(),
  }
}
