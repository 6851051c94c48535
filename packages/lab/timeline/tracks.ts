import { TICKS_PER_SECOND, type SimulationState } from '@botgarten/simulation'
import type { Tone, TrailPoint } from '../types.ts'

/** Trail points are this many ticks apart: ten a second. */
const TRAIL_EVERY = 6
const LONGEST = 6000

/** Where a robot has been and what it has sounded; frequency 0 is silence. Only the screen asks for it. */
export interface Track {
  readonly trail: TrailPoint[]
  readonly tones: Tone[]
  /** Seconds at which it began to touch something. */
  readonly bumps: number[]
}

export const newTrack = (): Track => ({ trail: [], tones: [], bumps: [] })

/** Which robots touch something. */
export const touchesIn = ({ robots }: SimulationState): readonly boolean[] =>
  robots.map(({ touching }) => touching.length > 0)

/** Writes down a tick that is over. @param touched which robots touched something before it */
export function note(
  tracks: readonly Track[],
  tick: number,
  { robots }: SimulationState,
  touched: readonly boolean[],
): void {
  const t = tick / TICKS_PER_SECOND
  robots.forEach(({ x, y, heading, tone, touching }, index) => {
    const { trail, tones, bumps } = tracks[index]!
    if (touching.length > 0 && !touched[index]) add(bumps, t)
    const frequency = tone?.frequency ?? 0
    if (frequency !== (tones.at(-1)?.frequency ?? 0)) add(tones, { t, frequency })
    if (tick % TRAIL_EVERY === 0) add(trail, { t, x, y, heading })
  })
}

function add<Item>(list: Item[], item: Item): void {
  list.push(item)
  if (list.length > LONGEST) list.splice(0, LONGEST / 10)
}

/** The same track up to a second. */
export const trackUntil = ({ trail, tones, bumps }: Track, seconds: number): Track => ({
  bumps: bumps.filter((t) => t <= seconds),
  trail: trail.filter(({ t }) => t <= seconds),
  tones: tones.filter(({ t }) => t <= seconds),
})
