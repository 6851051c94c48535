import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { cardConfig } from '@botgarten/simulation'
import type { Finding } from '@botgarten/blocks'
import type { LabSession } from '#lab/session.svelte.ts'
import { closeSessions, sessionOf } from '#lab/testing/session.ts'
import { addNeuron, applyFix } from './plug.ts'

let frames: number
let session: LabSession
/** The finding of a busy page comes after this number of frames. */
let later: number
let shown: Finding
beforeEach(() => {
  frames = 0
  later = 0
  shown = finding
  vi.stubGlobal('requestAnimationFrame', (done: () => void) => {
    frames += 1
    setTimeout(done, 0)
  })
  ;({ session } = sessionOf())
  Object.defineProperty(session, 'findings', { get: () => (frames > later ? [shown] : []) })
})
afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
})

/** A new neuron looks to port 4, where nothing is plugged in: it may look elsewhere, or get its sensor. */
const finding = {
  ...{ block: 'new', key: 'nothing-there', facts: { port: '4' } },
  fixes: [
    { field: 'INPUTNODE', value: 'ULTRASONIC_PORT_2' },
    { field: 'INPUTNODE', value: 'ULTRASONIC_PORT_1', plug: { port: '1', kind: 'ultrasonic' } },
    { field: 'INPUTNODE', value: 'ULTRASONIC_PORT_4', plug: { port: '4', kind: 'ultrasonic' } },
  ],
} as unknown as Finding

const set: object[] = []
const blocks = {
  setFields: (block: string, fields: object) => void set.push({ block, ...fields }),
  addNeuron: (): string | null => 'new',
}
const plugged = () =>
  Object.fromEntries(Object.entries(session.config.sensors).map(([port, { kind }]) => [port, kind]))
const before = { '1': 'colour', '2': 'ultrasonic', '3': 'ultrasonic' }

test('a new neuron gets its sensor at its own port, as one step to undo', async () => {
  expect(plugged()).toEqual(before)
  await addNeuron(session, blocks, 'net', 'input')
  expect(plugged()).toEqual({ ...before, '4': 'ultrasonic' })
  session.undo.undo()
  expect(session.config).toEqual(cardConfig)
})

test('a page that is busy plugs it in once it knows of the block', async () => {
  later = 30
  await addNeuron(session, blocks, 'net', 'input')
  expect(plugged()).toEqual({ ...before, '4': 'ultrasonic' })
})

test('a neuron that misses nothing, or that was not made, changes no plug', async () => {
  later = Infinity
  await addNeuron(session, blocks, 'net', 'input')
  expect([plugged(), frames]).toEqual([before, 40])
  await addNeuron(session, { ...blocks, addNeuron: () => null }, 'net', 'input')
  expect(frames).toBe(40)
})

test('a finding that has no sensor for its own port plugs nothing in', async () => {
  const [otherPort] = finding.fixes!
  const others = [{}, { fixes: [otherPort] }, { facts: { port: '4' }, fixes: [otherPort] }]
  for (const other of others) {
    shown = { block: 'new', key: 'nothing-there', ...other } as unknown as Finding
    await addNeuron(session, blocks, 'net', 'input')
    expect(plugged()).toEqual(before)
  }
})

test('a finding of another block plugs nothing in', async () => {
  await addNeuron(session, { ...blocks, addNeuron: () => 'other' }, 'net', 'input')
  expect(plugged()).toEqual(before)
})

test('a way out of a finding sets the field, and plugs a sensor in only where it names one', async () => {
  const [otherPort, , plug] = finding.fixes!
  applyFix(session, blocks, 'new', otherPort!)
  await vi.waitFor(() => expect(set).toEqual([{ block: 'new', INPUTNODE: 'ULTRASONIC_PORT_2' }]))
  expect(plugged()).toEqual(before)
  applyFix(session, blocks, 'new', plug!)
  await vi.waitFor(() => expect(plugged()).toEqual({ ...before, '4': 'ultrasonic' }))
})
