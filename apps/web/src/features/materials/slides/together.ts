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
