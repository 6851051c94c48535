import 'fake-indexeddb/auto'
import { afterEach, describe, expect, it } from 'vitest'
import { starterChoice } from '@botgarten/learning/neural-network/examples'
import { closeSessions, screen, sessionOf } from './testing/session.ts'

afterEach(closeSessions)

function taught() {
  const frame = screen()
  const { session, kinds } = sessionOf()
  const network = session.outlines[0]!.id
  const rows = () => session.examples.now(network)?.rows.length ?? 0
  return { session, kinds, network, rows, frame }
}

describe('examples in a session', () => {
  it('remembers one, takes it back, and saves each', () => {
    const { session, kinds, network, rows } = taught()
    expect(session.examples.remember(network, { left: 40, right: 50 })).toBe(true)
    session.examples.remember(network, { left: 0, right: 0 })
    expect(rows()).toBe(2)
    expect(session.project.brains[network]!.examples!.drives.map(({ id }) => id)).toEqual([
      'hand-1',
      'hand-2',
    ])
    expect(kinds()).toEqual(['examples', 'examples'])
    session.undo.undo()
    expect(rows()).toBe(1)
    session.undo.undo()
    expect(session.project.brains[network]!.examples).toBeUndefined()
    session.undo.redo()
    expect(rows()).toBe(1)
  })

  it('takes back a drive as one step, its weights as they were', () => {
    const { session, network, rows, frame } = taught()
    session.weights.turn(network, 'eyeLeft', 'wheelLeft', 0.4, 'whole')
    session.examples.record(network, 'pad')
    session.start()
    const stop = session.lab.run()
    session.lab.drive({ left: 60, right: 60 })
    for (let k = 0; k < 30; k++) frame()
    session.lab.drive(null)
    session.lab.stop()
    session.examples.stop()
    stop()
    expect(rows()).toBeGreaterThan(1)
    session.undo.undo()
    expect(rows()).toBe(0)
    expect(session.weights.now(network)['eyeLeft']!['wheelLeft']).toBe(0.4)
  })

  it('writes no more rows once recording has ended, though the run goes on', () => {
    const { session, network, rows, frame } = taught()
    session.examples.record(network, 'pad')
    session.start()
    const stop = session.lab.run()
    session.lab.drive({ left: 60, right: 60 })
    for (let k = 0; k < 10; k++) frame()
    session.examples.stop()
    const written = rows()
    expect(written).toBeGreaterThan(1)
    expect(session.lab.view.recording).toBeNull()
    for (let k = 0; k < 10; k++) frame()
    expect(rows()).toBe(written)
    stop()
  })

  it('chooses how it practises, before and after it has', () => {
    const { session, network } = taught()
    const { examples } = session
    const before = session.weights.now(network)
    expect(examples.choice(network)).toEqual(starterChoice)
    const bold = { seed: 5, settings: { ...starterChoice.settings, rate: 0.3 } }
    examples.choose(network, bold)
    expect(examples.choice(network)).toEqual(bold)
    examples.practised(network, { a: { b: 1 } }, { ...bold, start: {}, round: 60, curve: [], marks: [] })
    expect(session.weights.now(network)).toEqual({ a: { b: 1 } })
    examples.choose(network, starterChoice)
    expect(examples.choice(network)).toEqual(starterChoice)
    expect(session.project.brains[network]!.practice).toMatchObject({
      ...bold,
      round: 60,
      next: starterChoice,
    })
    session.undo.undo()
    expect(examples.choice(network)).toEqual(bold)
    session.undo.undo()
    expect(session.weights.now(network)).toEqual(before)
  })
})
