import type { View } from '@botgarten/lab'

/** What seldom changes in the views that come every frame. `chosen`: id of the robot whose network is shown. */
export function factsOf({ phase, time, brains, problem, checks, robots }: View, chosen: string) {
  const robot = robots.find(({ id }) => id === chosen) ?? robots[0]
  const passed = checks.filter((check) => check.passed)
  return {
    phase,
    /** A moment of the past is shown. */
    past: time.past,
    /** Nothing has run yet. */
    empty: time.now === 0,
    /** There is another future that could come back. */
    other: time.other,
    brains,
    problem,
    /** What keeps the chosen robot from going on. */
    stuck: robot?.problem ?? null,
    /** Checks of the card that are green, by id, and whether all are. */
    green: passed.map(({ id }) => id).join(' '),
    succeeded: checks.length > 0 && passed.length === checks.length,
    /** The first robot touches something. */
    touching: !!robots[0]?.touching[0],
    /** Hertz of the tone that is heard: the chosen robot's, else that of the first one that sounds. */
    heard: robot?.frequency ?? robots.find(({ frequency }) => frequency)?.frequency ?? null,
  }
}

export type Facts = ReturnType<typeof factsOf>

/** Those of before where nothing has changed: what is drawn from them is then not looked at again. */
export function renewed(before: Facts | undefined, now: Facts): Facts {
  const names = Object.keys(now) as (keyof Facts)[]
  return before && names.every((name) => before[name] === now[name]) ? before : now
}
