/**
 * Mascots beside the playground hold still: nothing moves beside what is to be seen, and an animation would be worked out
 * anew with every frame. Returns how to let them go on.
 */
export function holdStill(playground: Element): () => void {
  const held = document.getAnimations().filter(({ effect }) => {
    const target = effect instanceof KeyframeEffect ? effect.target : null
    return target && effect?.getTiming().iterations === Infinity && !playground.contains(target)
  })
  for (const one of held) one.pause()
  return () => {
    for (const one of held) if (one.playState === 'paused') one.play()
  }
}
