import {
  cardConfig,
  createSimulation,
  paintFloor,
  type Area,
  type LedColour,
  type World,
} from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import type { Check } from '../types.ts'
import { observe, results, watch } from './checks.ts'
import { seenBy } from '../testing/seen.ts'

const world: World = {
  size: { width: 400, height: 400 },
  floor: { colour: '#FFFFFF' },
  areas: [],
  lines: [],
  obstacles: [
    {
      id: 'square',
      shape: { kind: 'rectangle', width: 50, height: 50 },
      pose: { x: 200, y: 200, heading: 0 },
      fixed: true,
      colour: '#0057A6',
    },
  ],
  robots: [
    { id: 'bo', pose: { x: 200, y: 60, heading: 90 }, program: 'main', brain: '', config: cardConfig },
  ],
}

/** Lets the checks look at a robot that somebody moves by hand: a pose and what it touches a second. */
function watching(checks: readonly Check[]) {
  const simulation = createSimulation(world, paintFloor(world), 1)
  const robot = simulation.state.robots[0]!
  const watches = watch(checks)
  let tick = 0
  return {
    stands(
      y: number,
      seconds: number,
      { touching = [], percent = 0 }: { touching?: string[]; percent?: number } = {},
    ) {
      Object.assign(robot, { y, touching })
      robot.motors.B.percent = robot.motors.C.percent = percent
      for (const end = tick + seconds * 60; tick < end;)
        observe(checks, watches, ++tick / 60, seenBy(simulation))
      return Object.fromEntries(results(checks, watches).map(({ id, passed }) => [id, passed]))
    },
    results: () => results(checks, watches),
  }
}

// The square's near side is at y = 175, the robot's front edge 10 cm before its axle: at y = 165 the gap is 0.
const near: Check = { id: 'near', kind: 'near', numbers: { obstacle: 'square', cm: 8 }, seconds: 30 }
const stays: Check = {
  id: 'stays',
  kind: 'stays',
  numbers: { obstacle: 'square', cm: 8, percent: 3 },
  seconds: 5,
}
const never: Check = {
  id: 'never',
  kind: 'neverTouches',
  numbers: { obstacle: 'square', until: 'stays' },
  seconds: 5,
}
const away: Check = {
  id: 'away',
  kind: 'turnsAway',
  numbers: { obstacle: 'square', near: 60, far: 80 },
  seconds: 2,
}

const green: Area = {
  id: 'green',
  shape: { kind: 'rectangle', width: 400, height: 40 },
  pose: { x: 200, y: 120, heading: 0 },
  colour: '#00642E',
}

/** A robot that somebody moves over a green stripe (100 to 140 cm up), with a lamp in its hand. */
function crossing(checks: readonly Check[]) {
  const striped = { ...world, obstacles: [], areas: [green] }
  const simulation = createSimulation(striped, paintFloor(striped), 1)
  const watches = watch(checks)
  let tick = 0
  return {
    stands(x: number, y: number, seconds: number, led: LedColour | null = null, percent = 0) {
      simulation.place('bo', { x, y, heading: 90 })
      const robot = simulation.state.robots[0]!
      robot.led = led
      robot.motors.B.percent = robot.motors.C.percent = percent
      for (const end = tick + seconds * 60; tick < end;)
        observe(checks, watches, ++tick / 60, seenBy(simulation))
      return results(checks, watches).map(({ passed }) => passed)
    },
  }
}

describe('checks of lamps and places', () => {
  const lamp: Check = {
    id: 'green',
    kind: 'led',
    numbers: { colour: '#00642E', lamp: 'green' },
    seconds: 1,
  }
  const dark: Check = { id: 'dark', kind: 'led', numbers: { colour: '#FFFFFF', lamp: '' }, seconds: 1 }

  it('led: the lamp has to shine in its colour while the sensor, 5 cm ahead, sees the floor colour', () => {
    const lab = crossing([lamp])
    expect(lab.stands(200, 60, 3, 'green')).toEqual([false])
    expect(lab.stands(200, 115, 3, 'red')).toEqual([false])
    expect(lab.stands(200, 115, 3, null)).toEqual([false])
    expect(lab.stands(200, 115, 0.9, 'green')).toEqual([false])
    expect(lab.stands(200, 60, 0.1, 'green')).toEqual([false])
    expect(lab.stands(200, 97, 1, 'green')).toEqual([true])
    expect(lab.stands(200, 60, 1, 'red')).toEqual([true])
  })

  it('led: an empty name is a dark lamp', () => {
    const lab = crossing([dark])
    expect(lab.stands(200, 60, 2, 'orange')).toEqual([false])
    expect(lab.stands(200, 60, 1, null)).toEqual([true])
  })

  const place = { x: 200, y: 60, cm: 10, after: '' }
  const arrives: Check = { id: 'there', kind: 'arrives', numbers: place, seconds: 1 }

  it('arrives: the axle stands there, it does not only drive over', () => {
    const lab = crossing([arrives])
    expect(lab.stands(200, 71, 2)).toEqual([false])
    expect(lab.stands(200, 69, 2, null, 3)).toEqual([false])
    expect(lab.stands(200, 69, 0.9)).toEqual([false])
    expect(lab.stands(200, 69, 0.1)).toEqual([true])
    expect(lab.stands(200, 160, 1)).toEqual([true])
  })

  it('visits: every point once, in any order; arrives waits for it', () => {
    const visits: Check = {
      id: 'tour',
      kind: 'visits',
      numbers: { points: '200 60, 60 160, 200 160', cm: 10 },
      seconds: 30,
    }
    const home: Check = { ...arrives, id: 'home', numbers: { ...place, after: 'tour' } }
    const lab = crossing([visits, home])
    expect(lab.stands(200, 60, 2)).toEqual([false, false])
    expect(lab.stands(200, 160, 0.1, null, 30)).toEqual([false, false])
    expect(lab.stands(60, 171, 0.1, null, 30)).toEqual([false, false])
    expect(lab.stands(60, 151, 0.1, null, 30)).toEqual([true, false])
    expect(lab.stands(200, 60, 1)).toEqual([true, true])
  })
})

describe('checks of the senses', () => {
  const hold = (simulation: ReturnType<typeof createSimulation>, checks: readonly Check[]) => {
    const watches = watch(checks)
    const robot = simulation.state.robots[0]!
    let tick = 0
    return (now: Partial<typeof robot> & { percent?: number; x?: number; y?: number }, seconds: number) => {
      const { percent = 0, x = robot.x, y = robot.y, ...rest } = now
      simulation.place('bo', { x, y, heading: 90 })
      Object.assign(robot, rest)
      robot.motors.B.percent = robot.motors.C.percent = percent
      for (const end = tick + seconds * 60; tick < end;)
        observe(checks, watches, ++tick / 60, seenBy(simulation))
      return results(checks, watches).map(({ passed }) => passed)
    }
  }
  const stripes = {
    ...world,
    areas: [green, { ...green, id: 'black', pose: { x: 200, y: 300, heading: 0 }, colour: '#000000' }],
  }
  const on = (floor: World, checks: readonly Check[]) =>
    hold(createSimulation(floor, paintFloor(floor), 1), checks)
  const still = { ...stripes, obstacles: [] }

  it('rests: it has to be dark and the robot slow, both for five seconds', () => {
    const lab = on(still, [{ id: 'rests', kind: 'rests', numbers: { light: 15, percent: 8 }, seconds: 5 }])
    expect(lab({ y: 60 }, 6)).toEqual([false])
    expect(lab({ y: 295, percent: 8 }, 6)).toEqual([false])
    expect(lab({ percent: 7.9 }, 4.9)).toEqual([false])
    expect(lab({ percent: 7.9 }, 0.1)).toEqual([true])
  })

  it('speedOn: only the speed on its colour counts', () => {
    const numbers = { colour: '#00642E', least: 50, most: 100 }
    const lab = on(still, [{ id: 'fast', kind: 'speedOn', numbers, seconds: 1 }])
    expect(lab({ y: 60, percent: 80 }, 2)).toEqual([false])
    expect(lab({ y: 115, percent: 49 }, 2)).toEqual([false])
    expect(lab({ percent: 50 }, 1)).toEqual([true])
  })

  it('sings: two tones, near and far, that are apart', () => {
    const numbers = { near: 35, far: 90, hertz: 150 }
    const lab = on(stripes, [{ id: 'sings', kind: 'sings', numbers, seconds: 0 }])
    const tone = (frequency: number) => ({ tone: { frequency, untilTick: null } })
    expect(lab({ y: 40, ...tone(400) }, 0.1)).toEqual([false])
    expect(lab({ y: 145, ...tone(260) }, 0.1)).toEqual([false])
    expect(lab({ tone: null }, 0.1)).toEqual([false])
    expect(lab(tone(250), 0.1)).toEqual([true])
  })

  it('turnsBack: its sensor has read near, and far after that', () => {
    const turns = { id: 'turns', kind: 'turnsBack', numbers: { near: 35, far: 90 }, seconds: 0 }
    const lab = on(stripes, [turns])
    expect(lab({ y: 40 }, 0.1)).toEqual([false])
    expect(lab({ y: 145 }, 0.1)).toEqual([false])
    expect(lab({ y: 40 }, 0.1)).toEqual([true])
    expect(lab({ y: 145 }, 0.1)).toEqual([true])
  })

  it('says: one word, and another one than on the other colours', () => {
    const numbers = { colour: '#00642E', others: '#000000' }
    const lab = on(still, [{ id: 'green', kind: 'says', numbers, seconds: 1 }])
    expect(lab({ y: 295, display: ['A', '∅'] }, 1)).toEqual([false])
    expect(lab({ y: 115, display: ['A', '∅'] }, 2)).toEqual([false])
    expect(lab({ display: ['A', 'B'] }, 2)).toEqual([false])
    expect(lab({ display: ['∅', 'B'] }, 1)).toEqual([true])
  })

  it('says: what was never on another colour has not told them apart', () => {
    const numbers = { colour: '#00642E', others: '#000000' }
    const lab = on(still, [{ id: 'green', kind: 'says', numbers, seconds: 1 }])
    expect(lab({ y: 115, display: ['B'] }, 2)).toEqual([false])
    expect(lab({ y: 295, display: [] }, 0.1)).toEqual([true])
  })

  it('silent: no word on this colour, for its seconds without a break', () => {
    const lab = on(still, [{ id: 'green', kind: 'silent', numbers: { colour: '#00642E' }, seconds: 1 }])
    expect(lab({ y: 295, display: ['∅'] }, 2)).toEqual([false])
    expect(lab({ y: 115, display: ['A', '∅'] }, 2)).toEqual([false])
    expect(lab({ display: ['∅', '∅'] }, 0.5)).toEqual([false])
    expect(lab({ display: ['∅', '∅'] }, 1)).toEqual([true])
  })

  it('laps: gate by gate in order, once round from where it began', () => {
    const numbers = { gates: '100 60, 300 60, 200 350', cm: 20, laps: 1 }
    const lab = on(still, [{ id: 'lap', kind: 'laps', numbers, seconds: 0 }])
    expect(lab({ x: 110, y: 70 }, 0.1)).toEqual([false])
    expect(lab({ x: 200, y: 340 }, 0.1)).toEqual([false])
    expect(lab({ x: 300, y: 60 }, 0.1)).toEqual([false])
    expect(lab({ x: 100, y: 60 }, 0.1)).toEqual([false])
    expect(lab({ x: 200, y: 340 }, 0.1)).toEqual([false])
    expect(lab({ x: 100, y: 60 }, 0.1)).toEqual([true])
  })

  it('neverSees: one look is one too many, until the task is done', () => {
    const lap: Check = {
      id: 'lap',
      kind: 'laps',
      numbers: { gates: '200 300, 200 115', cm: 20, laps: 1 },
      seconds: 0,
    }
    const never: Check = {
      id: 'never',
      kind: 'neverSees',
      numbers: { colour: '#FFFFFF', until: 'lap' },
      seconds: 2,
    }
    const careful = on(still, [lap, never])
    expect(careful({ y: 295 }, 1)).toEqual([false, false])
    expect(careful({ y: 115 }, 1)).toEqual([false, true])
    expect(careful({ y: 295 }, 0.1)).toEqual([true, true])
    expect(careful({ y: 60 }, 0.1)).toEqual([true, true])
    const careless = on(still, [lap, never])
    expect(careless({ y: 60 }, 3)).toEqual([false, false])
    expect(careless({ y: 295 }, 3)[1]).toBe(false)
  })
})

describe('checks', () => {
  it('near: measured from the front edge, to the outline, and it stays passed', () => {
    const lab = watching([near])
    expect(lab.stands(156.9, 1)).toEqual({ near: false })
    expect(lab.stands(157.1, 1)).toEqual({ near: true })
    expect(lab.stands(50, 1)).toEqual({ near: true })
    expect(lab.results()[0]!.at).toBeCloseTo(1 + 1 / 60, 9)
  })

  it('stays: slower than 3 percent for five seconds without a break', () => {
    const lab = watching([stays])
    expect(lab.stands(160, 4.9, { percent: 2.9 })).toEqual({ stays: false })
    expect(lab.stands(160, 0.5, { percent: 3 })).toEqual({ stays: false })
    expect(lab.stands(160, 4.9, { percent: 2.9 })).toEqual({ stays: false })
    expect(lab.stands(160, 0.1, { percent: 2.9 })).toEqual({ stays: true })
    expect(lab.stands(100, 0.1)).toEqual({ stays: false })
  })

  it('stays: what twitches for a tick now and then stands, as it does to the eye', () => {
    const lab = watching([stays])
    for (let second = 0; second < 6; second += 1) {
      lab.stands(160, 59 / 60, { percent: 0 })
      lab.stands(160, 1 / 60, { percent: 30 })
    }
    expect(lab.stands(160, 1 / 60)).toEqual({ stays: true })
  })

  it('neverTouches: one touch is one too many, but only until the task is done', () => {
    const clumsy = watching([stays, never])
    expect(clumsy.stands(165, 1, { touching: ['square'] })).toMatchObject({ never: false })
    expect(clumsy.stands(160, 6)).toMatchObject({ never: false })
    const gentle = watching([stays, never])
    expect(gentle.stands(160, 6, { touching: ['edge'] })).toMatchObject({ stays: true, never: true })
    expect(gentle.stands(160, 1, { touching: ['square'] })).toMatchObject({ never: true })
  })

  it('neverTouches: is not yet passed before its seconds are over', () => {
    expect(watching([never]).stands(60, 4.9)).toEqual({ never: false })
  })

  it('turnsAway: first near, then far for two seconds', () => {
    const lab = watching([away])
    expect(lab.stands(60, 5)).toEqual({ away: false })
    expect(lab.stands(110, 1)).toEqual({ away: false })
    expect(lab.stands(84, 1.9)).toEqual({ away: false })
    expect(lab.stands(84, 0.1)).toEqual({ away: true })
    expect(lab.stands(110, 1)).toEqual({ away: true })
  })

  it('an obstacle that is gone passes nothing, a kind that does not exist is refused by name', () => {
    const gone = watching(
      [near, stays].map((check) => ({ ...check, numbers: { ...check.numbers, obstacle: 'nothing' } })),
    )
    expect(gone.stands(160, 6)).toEqual({ near: false, stays: false })
    expect(() => watch([{ ...near, kind: 'constructor' }])).toThrow('constructor')
  })
})
