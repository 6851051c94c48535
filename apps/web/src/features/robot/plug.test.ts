import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { cardConfig } from '@botgarten/simulation'
import type { Finding } from '@botgarten/blocks'
import type { LabSession } from '#lab/session.svelte.ts'
import { closeSessions, sessionOf } from '#lab/testing/session.ts'
import { applyFix } from './plug.ts'

let session: LabSession
beforeEach(() => {
  vi.stubGlobal('requestAnimationFrame', (done: () => void) => setTimeout(done, 0))
  ;({ session } = sessionOf())
})
afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
})

/** A neuron looks to port 4, where nothing is plugged in: it may look elsewhere, or get its sensor. */
const finding = {
  ...{ block: 'new', key: 'nothing-there', facts: { port: '4' } },
  fixes: [
    { field: 'INPUTNODE', value: 'ULTRASONIC_PORT_2' },
    { field: 'INPUTNODE', value: 'ULTRASONIC_PORT_1', plug: { port: '1', kind: 'ultrasonic' } },
    { field: 'INPUTNODE', value: 'ULTRASONIC_PORT_4', plug: { port: '4', kind: 'ultrasonic' } },
  ],
} as unknown as Finding

const set: object[] = []
const blocks = { setFields: (block: string, fields: object) => void set.push({ block, ...fields }) }
const plugged = () =>
  Object.fromEntries(Object.entries(session.config.sensors).map(([port, { kind }]) => [port, kind]))
const before = { '1': 'colour', '2': 'ultrasonic', '3': 'ultrasonic' }

test('a way out of a finding sets the field, and plugs a sensor in only where it names one', async () => {
  const [otherPort, , plug] = finding.fixes!
  applyFix(session, blocks, 'new', otherPort!)
  await vi.waitFor(() => expect(set).toEqual([{ block: 'new', INPUTNODE: 'ULTRASONIC_PORT_2' }]))
  expect(plugged()).toEqual(before)
  applyFix(session, blocks, 'new', plug!)
  await vi.waitFor(() => expect(plugged()).toEqual({ ...before, '4': 'ultrasonic' }))
  session.undo.undo()
  expect(session.config).toEqual(cardConfig)
})
