import fc from 'fast-check'
import { expect, test } from 'vitest'
import { leaveOut } from '@botgarten/learning/neural-network/explain'
import { withWeight } from '@botgarten/learning/neural-network/brain'
import type { Lab } from '../index.ts'
import { drive, forever, labWith, net, program } from '../testing/scene.ts'
import { gridOf, imagine, readingsAt, type Standpoint } from './index.ts'

const standpoint = (lab: Lab): Standpoint => {
  const { phase } = lab.view()
  return {
    document: lab.document(),
    floor: lab.floor(),
    moment: lab.state(),
    going: phase === 'running' || phase === 'paused',
  }
}

function toEnd<Result>(steps: Generator<undefined, Result>): Result {
  for (;;) {
    const { done, value } = steps.next()
    if (done) return value
  }
}

const goesOn = (lab: Lab, ticks: number, brains = {}) => toEnd(imagine(standpoint(lab), 'bo', brains, ticks))

const running = (ticks: number) => {
  const lab = labWith(program(forever(net())))
  lab.start()
  lab.advance(ticks)
  return lab
}

test('what is imagined from any moment is what comes, to the last bit', () => {
  fc.assert(
    fc.property(fc.integer({ min: 0, max: 900 }), fc.integer({ min: 1, max: 200 }), (from, ticks) => {
      const lab = running(from)
      const { poses } = goesOn(lab, ticks)
      expect(poses).toHaveLength(ticks + 1)
      expect(poses[0]).toEqual(lab.view().robots[0]!.pose)
      lab.advance(ticks)
      expect(poses.at(-1)).toEqual(lab.view().robots[0]!.pose)
    }),
    { seed: 7, numRuns: 25 },
  )
})

test('a moment of the past goes on as it went on then', () => {
  const lab = running(400)
  const then = lab.view().robots[0]!.pose
  lab.goTo(150)
  expect(goesOn(lab, 250).poses.at(-1)).toEqual(then)
})

test('imagining changes nothing in the lab', () => {
  const lab = running(120)
  const before = JSON.stringify([lab.state(), lab.hash(), lab.document()])
  goesOn(lab, 100, { net: leaveOut(lab.document().brains['net']!, 'eyeLeft') })
  toEnd(readingsAt(standpoint(lab), 'bo', ['eyeLeft'], gridOf({ width: 400, height: 400 }, 30, 0).poses))
  expect(JSON.stringify([lab.state(), lab.hash(), lab.document()])).toBe(before)
})

test('with another weight it drives as a lab drives whose knob is turned at that moment', () => {
  const lab = running(200)
  const other = withWeight(lab.document().brains['net']!, 'eyeRight', 'wheelLeft', 0.37)
  const { poses } = goesOn(lab, 180, { net: other })
  lab.setWeight('net', 'eyeRight', 'wheelLeft', 0.37)
  lab.advance(180)
  expect(poses.at(-1)).toEqual(lab.view().robots[0]!.pose)
})

test('with the left eye left out its wheel stands, and the other turns Bo round it', () => {
  const lab = running(10)
  const { poses } = goesOn(lab, 60, { net: leaveOut(lab.document().brains['net']!, 'eyeLeft') })
  expect(poses.at(-1)!.heading).toBeGreaterThan(poses[0]!.heading + 20)
})

test('before Start it is the drive that Start would begin', () => {
  const lab = labWith(program(forever(net())))
  const { poses } = goesOn(lab, 90)
  lab.start()
  lab.advance(90)
  expect(poses.at(-1)).toEqual(lab.view().robots[0]!.pose)
})

test('it says when the robot touches something, and ends where the program ends', () => {
  const lab = labWith(program(drive('far', 60, 300)))
  lab.setStops([])
  lab.start()
  const { touchedAt, poses } = goesOn(lab, 900)
  expect(touchedAt).toBeGreaterThan(0)
  lab.advance(touchedAt! - 1)
  expect(lab.view().robots[0]!.touching).toEqual([])
  lab.advance(1)
  expect(lab.view().robots[0]!.touching).not.toEqual([])
  const short = labWith(program(drive('short', 60, 5)))
  short.start()
  expect(goesOn(short, 900).poses.length).toBeLessThan(100)
  expect(poses.length).toBeGreaterThan(100)
})

test('it pauses after every 20 ticks, so that a screen can be drawn meanwhile', () => {
  const steps = imagine(standpoint(running(5)), 'bo', {}, 100)
  let pauses = 0
  while (!steps.next().done) pauses++
  expect(pauses).toBe(100 / 20)
})

test('a robot that is not there stands nowhere', () => {
  expect(toEnd(imagine(standpoint(running(5)), 'nobody', {}, 10))).toEqual({ poses: [], touchedAt: null })
})

test('a grid covers the floor evenly, with about so many poses', () => {
  fc.assert(
    fc.property(fc.integer({ min: 50, max: 600 }), fc.integer({ min: 50, max: 600 }), (width, height) => {
      const { poses, spacing } = gridOf({ width, height }, 400, 30)
      expect(poses.length).toBeGreaterThan(330)
      expect(poses.length).toBeLessThan(470)
      for (const { x, y, heading } of poses) {
        expect(heading).toBe(30)
        expect(Math.min(x, width - x, y, height - y)).toBeGreaterThan(spacing / 3)
      }
    }),
    { seed: 7 },
  )
})

test('readings over the floor are those of a robot that is put there', () => {
  const lab = labWith(program(forever(net())))
  const { poses } = gridOf({ width: 400, height: 400 }, 60, 45)
  const readings = toEnd(readingsAt(standpoint(lab), 'bo', ['eyeLeft', 'eyeRight'], poses))
  expect(readings).toHaveLength(poses.length)
  let there = 0
  poses.forEach((pose, index) => {
    const came = lab.place('bo', pose)
    const fits = Math.abs(came.x - pose.x) + Math.abs(came.y - pose.y) < 0.1
    const { outputs } = lab.view().networks['net']!
    expect(readings[index]).toEqual(fits ? [outputs['eyeLeft'], outputs['eyeRight']] : null)
    there += Number(fits)
  })
  // The boxes leave no room where they stand.
  expect(there).toBeGreaterThan(40)
  expect(there).toBeLessThan(poses.length)
})

test('the field of a robot that is not there is empty, and inputs that cannot be read count 0', () => {
  const lab = labWith(program(forever(net())))
  const poses = [{ x: 60, y: 60, heading: 0 }]
  expect(toEnd(readingsAt(standpoint(lab), 'nobody', ['eyeLeft'], poses))).toEqual([null])
  expect(toEnd(readingsAt(standpoint(lab), 'bo', [], poses))).toEqual([[]])
})
