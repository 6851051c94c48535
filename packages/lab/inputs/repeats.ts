import type { Input } from './input.ts'

/** Does an input that follows another in the same moment leave nothing of that one? A knob turned further, a thing moved on. */
export function repeats(last: Input, next: Input): boolean {
  if (last.kind === 'weight' && next.kind === 'weight')
    return (
      last.brain === next.brain && last.from === next.from && last.to === next.to && last.set === next.set
    )
  if (last.kind === 'brain' && next.kind === 'brain') return last.brain === next.brain
  if (last.kind === 'drive' && next.kind === 'drive') return last.robot === next.robot
  return last.kind === 'place' && next.kind === 'place' && last.id === next.id
}
