/** Pauses what plays when the page is hidden or Escape is pressed. Returns how to end it. */
export function pauseWhenAway(pause: () => void): () => void {
  const away = () => document.hidden && pause()
  const escape = ({ key }: KeyboardEvent) => key === 'Escape' && pause()
  document.addEventListener('visibilitychange', away)
  window.addEventListener('keydown', escape)
  return () => {
    document.removeEventListener('visibilitychange', away)
    window.removeEventListener('keydown', escape)
  }
}
