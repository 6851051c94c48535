import 'fake-indexeddb/auto'
import { weightsOf, withActivation, withWeight } from '@botgarten/learning/neural-network'
import type { NetworkOutline } from '@botgarten/programs'
import { BrainError, parseBrainFile } from '@botgarten/programs/brain-file'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { closeSessions, sessionOf } from '#lab/testing/session.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import { withRobot } from '#lab/robots.ts'
import { friendship } from '#storage/testing/sample.ts'
import { canGrow, roomFor, setActivation } from './edits.ts'
import * as brains from './saved-brains.ts'

let session: LabSession
let net: NetworkOutline
beforeEach(() => {
  session = sessionOf(friendship, { isCard: false }).session
  net = session.outlines[0]!
})
afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

const turn = (weight: number) => session.weights.turn('net', 'eyeLeft', 'wheelRight', weight, 'whole')
const now = () => session.weights.now('net')['eyeLeft']!['wheelRight']
const sets = () => session.lab.document.brains['net']!.sets

describe('the list of saved brains', () => {
  test('calls a brain without a name “Brain”, and the next one “Brain 2”', () => {
    for (const name of ['', ' ']) brains.put(session, net, name)
    expect(brains.savedBrains(session, net)).toEqual(['Brain', 'Brain 2'])
  })

  test('takes the weights of now under a name that is free, and gives them back', () => {
    turn(0.3)
    brains.put(session, net, 'Shy')
    turn(0.8)
    brains.put(session, net, 'Shy')
    const [first, second] = brains.savedBrains(session, net)
    expect([first, second === first, brains.savedBrains(session, net).length]).toEqual(['Shy', false, 2])
    brains.take(session, net, 'Shy')
    expect(now()).toBe(0.3)
    brains.take(session, net, second!)
    expect(now()).toBe(0.8)
  })

  test('is changed in steps that can be undone', () => {
    turn(0.3)
    brains.put(session, net, 'Shy')
    brains.remove(session, net, 'Shy')
    expect(brains.savedBrains(session, net)).toEqual([])
    session.undo.undo()
    expect(brains.savedBrains(session, net)).toEqual(['Shy'])
  })

  test('gives a brain another name in its place, unless it is taken', () => {
    for (const name of ['One', 'Two', 'Three']) brains.put(session, net, name)
    brains.rename(session, net, 'Two', 'Zwei')
    expect(brains.savedBrains(session, net)).toEqual(['One', 'Zwei', 'Three'])
    brains.rename(session, net, 'Zwei', 'Three')
    const [, renamed] = brains.savedBrains(session, net)
    expect([renamed === 'Three', new Set(brains.savedBrains(session, net)).size]).toEqual([false, 3])
    const { canUndo } = session.undo
    brains.rename(session, net, 'One', 'One')
    brains.rename(session, net, 'One', '  ')
    expect([brains.savedBrains(session, net)[0], canUndo]).toEqual(['One', true])
  })

  test('has no name of a robot, and not the weights that another robot drives with', () => {
    brains.put(session, net, 'bo')
    expect(brains.savedBrains(session, net)).not.toContain('bo')
    const { document } = withRobot(session.lab.document, 'bo', 'shared')
    const two = sessionOf({ ...friendship, ...document }, { isCard: false }).session
    expect(Object.keys(two.lab.document.brains['net']!.sets)).toContain('bo2')
    expect(brains.savedBrains(two, net)).toEqual(brains.savedBrains(session, net))
    expect(brains.others(two)).toEqual([{ id: 'bo2', index: 1 }])
  })
})

describe('a brain file', () => {
  test('brings the same weights back, under a name that is free', async () => {
    turn(0.3)
    brains.put(session, net, 'Shy')
    const { layers } = session.lab.document.brains['net']!
    // A file is handed to the browser as a link that is pressed.
    const files: Blob[] = []
    const link = { click: () => {}, remove: () => {}, href: '', download: '' }
    vi.stubGlobal('document', { createElement: () => link, body: { append: () => {} } })
    vi.spyOn(URL, 'createObjectURL').mockImplementation((file) => `blob:${files.push(file as Blob)}`)
    brains.save(session, net, 'Shy')
    const text = await files[0]!.text()
    expect(parseBrainFile(text).name).toBe('Shy')
    const name = brains.load(session, net, text)
    expect(name).not.toBe('Shy')
    // A weight of 0 is the same as none.
    expect(sets()[name]).toEqual({ eyeLeft: { wheelRight: 0.3 } })
    expect(session.lab.document.brains['net']!.layers).toEqual(layers)
  })

  test('that is none is refused, and nothing changes', () => {
    expect(() => brains.load(session, net, '{}')).toThrow(BrainError)
    expect(brains.savedBrains(session, net)).toEqual([])
  })
})

describe('a brain that is given away', () => {
  test('is that of the other robot from now on, and the own one stays', () => {
    const { document } = withRobot(session.lab.document, 'bo', 'shared')
    const two = sessionOf({ ...friendship, ...document }, { isCard: false }).session
    two.weights.change('net', (brain) => withWeight(brain, 'eyeLeft', 'wheelRight', 0.7, ''))
    brains.put(two, net, 'Bold')
    brains.give(two, net, 'Bold', 'bo2')
    const brain = two.lab.document.brains['net']!
    expect(weightsOf(brain, 'bo2')['eyeLeft']!['wheelRight']).toBe(0.7)
    expect(weightsOf(brain, '')['eyeLeft']!['wheelRight']).toBe(0.7)
  })

  test('is refused where there is no such robot, or it has no network', () => {
    brains.put(session, net, 'Bold')
    expect(() => brains.give(session, net, 'Bold', 'bo2')).toThrow(BrainError)
    const { document } = withRobot(session.lab.document, 'bo', 'own')
    const programs = { ...document.programs, bo2: { stacks: [], config: { stacks: [] } } }
    const two = sessionOf({ ...friendship, ...document, programs }, { isCard: false }).session
    brains.put(two, net, 'Bold')
    expect(() => brains.give(two, net, 'Bold', 'bo2')).toThrow(BrainError)
  })
})

describe('the size of a network', () => {
  const layer = (id: string, neurons: number) => ({ id, neurons }) as NetworkOutline['hidden'][number]

  test('leaves room for what all its layers have not taken', () => {
    const none = roomFor(net)
    expect(roomFor({ ...net, hidden: [layer('a', 3), layer('b', 4)] })).toBe(none - 7)
    // It has two inputs and two outputs.
    expect(roomFor({ ...net, inputs: [], outputs: [] })).toBe(none + 4)
  })

  test('a layer grows while it and the network have room', () => {
    const none = roomFor(net)
    expect([canGrow(net, 1), canGrow({ ...net, hidden: [layer('a', none)] }, 1)]).toEqual([true, false])
    expect(canGrow(net, 1000)).toBe(false)
  })
})

describe('an activation', () => {
  test('of an output is part of the brain', () => {
    setActivation(session, undefined, net, 'wheelLeft', 'tanh')
    const brain = session.lab.document.brains['net']!
    expect(brain).toEqual(withActivation(friendship.brains['net']!, 'wheelLeft', 'tanh'))
  })

  test('of a hidden neuron is set at its block, for the whole layer; softmax is none for it', () => {
    const set: unknown[] = []
    const blocks = { setLayerActivation: (...what: unknown[]) => set.push(what) }
    const deep = { ...net, hidden: [{ id: 'hidden', neurons: 2 }] } as unknown as NetworkOutline
    setActivation(session, blocks as never, deep, 'hidden#1', 'tanh')
    setActivation(session, blocks as never, deep, 'hidden#1', 'softmax')
    setActivation(session, undefined, deep, 'hidden#1', 'tanh')
    expect(set).toEqual([['hidden', 'tanh']])
    expect(session.lab.document.brains['net']).toEqual(friendship.brains['net'])
  })
})
