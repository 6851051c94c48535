import 'fake-indexeddb/auto'
import { weightsOf, type Weights } from '@botgarten/learning/neural-network'
import { noExamples, withDrive } from '@botgarten/learning/neural-network/examples'
import { withHidden } from '@botgarten/programs/examples'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { closeSessions, screen, sessionOf } from '#lab/testing/session.ts'
import { Practice } from './practice.svelte.ts'

afterEach(closeSessions)

const rows = [
  [40, 40, 45, 45],
  [39, 59, 25, 60],
  [68, 100, 50, 90],
  [100, 53, 65, 25],
  [29, 28, 25, 25],
  [7, 7, 0, 0],
] as const

/** Six rows of the picture, practised by a child on the card Friendship. */
function practising() {
  screen()
  const { session } = sessionOf()
  const network = session.outlines[0]!.id
  const shown = rows.map(([a, b, l, r], tick) => ({
    ...{ tick: 60 * tick, pose: { x: 50, y: 50, heading: 0 } },
    ...{ inputs: [a, b], outputs: [l, r] },
  }))
  const none = noExamples(['eyeLeft', 'eyeRight'], ['wheelLeft', 'wheelRight'])
  const { examples } = withDrive(none, { id: 'pad-1', by: 'pad', seed: 1 }, shown)
  session.examples.replace(network, examples)
  const practice = new Practice(session)
  const weights = (): Weights => weightsOf(session.lab.document.brains[network]!, session.robot.brain)
  const rest = () => vi.waitFor(() => expect(practice.phase).toBe('rest'))
  const practised = async () => {
    practice.practise()
    await rest()
  }
  return { session, network, practice, weights, rest, practised }
}

describe('practice', () => {
  it('moves the knobs, and one undo brings the old ones back', async () => {
    const { session, practice, weights, practised } = practising()
    session.weights.turn('net', 'eyeLeft', 'wheelLeft', 0.4, 'whole')
    const before = weights()
    await practised()
    expect(practice.outcome.round).toBe(60)
    expect(weights()).not.toEqual(before)
    expect(practice.outcome.point!.practised).toBeLessThan(practice.outcome.curve[0]!.practised / 3)
    session.undo.undo()
    expect(weights()).toEqual(before)
    expect(practice.outcome.curve).toEqual([])
    session.undo.redo()
    expect(practice.outcome.round).toBe(60)
  })

  it('keeps its choice the same object however often it moves the knobs: rows are laid out by it', async () => {
    const { practice, practised } = practising()
    const before = practice.choice
    await practised()
    expect(practice.choice).toBe(before)
    practice.choose({ rate: 0.3 })
    expect(practice.choice.settings.rate).toBe(0.3)
  })

  it('goes back to a round and on from there, bit for bit as if it had never stopped', async () => {
    const straight = practising()
    straight.practice.choose({ rounds: 120 })
    await straight.practised()
    const { practice, weights, practised, rest } = practising()
    await practised()
    practice.goTo(20, true)
    expect(practice.outcome.round).toBe(20)
    await practised()
    expect(practice.outcome.round).toBe(80)
    await rest()
    practice.goTo(60, true)
    await practised()
    expect(practice.outcome.round).toBe(120)
    expect(weights()).toEqual(straight.weights())
    expect(practice.outcome.curve.map(({ round }) => round)).toEqual(Array.from({ length: 121 }, (_, k) => k))
  })

  it('goes on after a while with what the project says, as if nobody had left', async () => {
    const { session, practice, network, weights, practised } = practising()
    await practised()
    practice.close()
    const again = new Practice(session)
    expect(again.outcome.round).toBe(60)
    again.goTo(7, true)
    await vi.waitFor(() => expect(again.outcome.round).toBe(7))
    await vi.waitFor(() => expect(again.phase).toBe('rest'))
    again.goTo(60, true)
    again.practise()
    await vi.waitFor(() => expect(again.outcome.round).toBe(120))
    const straight = practising()
    straight.practice.choose({ rounds: 120 })
    await straight.practised()
    expect(weights()).toEqual(straight.weights())
    expect(session.project.brains[network]!.practice!.round).toBe(120)
  })

  it('begins a curve of its own where a hand has turned a knob', async () => {
    const { session, practice, practised } = practising()
    await practised()
    session.weights.turn('net', 'eyeLeft', 'wheelLeft', 0.9, 'whole')
    await practised()
    expect(practice.outcome.curve.at(-1)!.round).toBe(60)
  })

  it('begins from zero as one step', async () => {
    const { session, practice, weights, practised } = practising()
    await practised()
    const learned = weights()
    practice.fromZero()
    expect(weights()['eyeLeft']!['wheelLeft']).toBe(0)
    session.undo.undo()
    expect(weights()).toEqual(learned)
  })

  it('opens an example in seven beats, and the knobs move in the last one', async () => {
    const { session, practice, weights } = practising()
    const { beats } = practice
    const before = weights()
    practice.open()
    await vi.waitFor(() => expect(beats.trace).not.toBeNull())
    for (let beat = 0; beat < 5; beat++) beats.next()
    expect(beats.beat).toBe('arrows')
    expect(weights()).toEqual(before)
    const moved = beats.trace!.links.find(({ from, to }) => from === 'eyeLeft' && to === 'wheelLeft')!
    beats.next()
    await vi.waitFor(() => expect(weights()['eyeLeft']!['wheelLeft']).toBe(moved.after))
    beats.close()
    session.undo.undo()
    expect(weights()).toEqual(before)
  })

  it('stops where the examples change, and keeps what it has come to', async () => {
    const { session, network, practice, practised, weights } = practising()
    practice.pace = 10
    practice.practise()
    await vi.waitFor(() => expect(practice.outcome.round).toBeGreaterThan(1))
    session.examples.remember(network, { left: 10, right: 20 })
    expect(practice.phase).toBe('rest')
    const { eyeLeft } = weights()
    expect(eyeLeft!['wheelLeft']).not.toBe(0)
    practice.pace = Infinity
    await practised()
    expect(practice.outcome.curve.map(({ round }) => round)).toEqual(Array.from({ length: 61 }, (_, k) => k))
  })

  it('marks the rounds that Bo drove with', async () => {
    const { session, practice, practised } = practising()
    await practised()
    session.start()
    expect(practice.outcome.marks).toEqual([60])
    session.lab.stop()
  })

  it('rests for the eye as soon as a hand pauses it, and at a whole round', async () => {
    const straight = practising()
    const { practice, rest, weights } = practising()
    practice.choose({ rounds: 1000 })
    practice.pace = 60
    practice.practise()
    await vi.waitFor(() => expect(practice.outcome.round).toBeGreaterThan(1))
    practice.pause()
    expect(practice.rests).toBe(true)
    await rest()
    straight.practice.choose({ rounds: practice.outcome.round })
    await straight.practised()
    expect(weights()).toEqual(straight.weights())
  })

  it('stops at once where the network changes, and practises the new one', async () => {
    const { session, network, practice, practised } = practising()
    practice.pace = 10
    practice.practise()
    await vi.waitFor(() => expect(practice.outcome.round).toBeGreaterThan(1))
    const { main } = session.project.programs
    const after = withHidden(main!, network, [{ neurons: 2, activation: 'tanh' }])
    session.apply({ kind: 'program', program: 'main', after })
    expect(practice.phase).toBe('rest')
    practice.pace = Infinity
    await practised()
    expect(practice.layers.map((layer) => layer.length)).toEqual([2, 2, 2])
    expect(practice.outcome.round).toBe(60)
    expect(practice.outcome.curve.map(({ round }) => round)).toEqual(Array.from({ length: 61 }, (_, k) => k))
  })

  it('is a step before the blocks that stop it, and undo takes it back where nothing else came after', async () => {
    const { session, practice, weights } = practising()
    const goes = async () => {
      practice.pace = 10
      const from = practice.outcome.round
      practice.practise()
      await vi.waitFor(() => expect(practice.outcome.round).toBeGreaterThan(from + 1))
      return weights()
    }
    session.weights.turn('net', 'eyeLeft', 'wheelLeft', 0.4, 'whole')
    const turned = weights()
    session.moveBlocks = () => true
    await goes()
    session.noteBlocks('main')
    expect(practice.phase).toBe('rest')
    const practised = weights()
    session.undo.undo()
    expect(weights()).toEqual(practised)
    session.undo.undo()
    expect(weights()).toEqual(turned)

    await goes()
    session.undo.undo()
    expect(practice.phase).toBe('rest')
    expect(weights()).toEqual(turned)
    session.undo.undo()
    expect(weights()).not.toEqual(turned)
  })

  it('practises where all wishes are equal and one reading never changes', async () => {
    const { session, network, practice, practised } = practising()
    const examples = session.examples.now(network)!
    const alike = examples.rows.map((row) => [...row.slice(0, 7), 50, 40, 40])
    session.examples.replace(network, { ...examples, rows: alike })
    await practised()
    expect(practice.outcome.ending).toEqual({ kind: 'rounds' })
    expect(practice.outcome.point!.practised).toBeLessThan(practice.outcome.curve[0]!.practised)
  })

  it('is off where every row is set aside, and on again with one', () => {
    const { session, practice, network } = practising()
    const examples = session.examples.now(network)!
    const aside = examples.rows.map((row) => row.with(5, 0))
    session.examples.replace(network, { ...examples, rows: aside })
    expect(practice.obstacle).toEqual({ kind: 'noRows' })
    session.examples.replace(network, { ...examples, rows: [examples.rows[0]!, ...aside.slice(1)] })
    expect(practice.obstacle).toBeNull()
  })

  it('says why it cannot practise', () => {
    const { session, practice, network } = practising()
    expect(practice.obstacle).toBeNull()
    session.examples.replace(network, undefined)
    expect(practice.obstacle).toEqual({ kind: 'noRows' })
  })
})
