import { noExamples, withDrive, type Exercise } from '@botgarten/learning/neural-network/examples'
import { starter } from '@botgarten/learning/neural-network/train'
import { afterEach, expect, test, vi } from 'vitest'
import { Engine } from './engine.ts'
import type { Order, Report } from './messages.ts'

const neuron = (id: string) => ({ id, activation: 'identity' as const, bias: 0 })
const shown = [20, 50, 80].map((eye, k) => ({
  ...{ tick: 6 * k, pose: { x: 1, y: 1, heading: 0 } },
  ...{ inputs: [eye], outputs: [100 - eye] },
}))
const none = noExamples(['eye'], ['wheel'])
const { examples } = withDrive(none, { id: 'pad-1', by: 'pad', seed: 1 }, shown)
const exercise: Exercise = {
  ...{ id: 'net', layers: [[neuron('eye')], [neuron('wheel')]], weights: {}, examples, seed: 1 },
  ...{ keepBack: 0, from: 'knobs', mirror: null },
}
const orders: readonly Order[] = [
  { kind: 'begin', job: 1, exercise, settings: starter },
  { kind: 'go', until: 60, pace: Infinity },
]

/** A worker that takes so many orders and dies at the next one. */
function dyingAfter(most: number) {
  return class {
    onerror: (() => void) | null = null
    onmessageerror: (() => void) | null = null
    onmessage = null
    #taken = 0
    postMessage() {
      if (this.#taken++ === most) queueMicrotask(() => this.onerror?.())
    }
    terminate() {}
  }
}

/** The weights that 60 rounds end with. */
async function practised(): Promise<readonly number[]> {
  const reports: Report[] = []
  const engine = new Engine((report) => {
    reports.push(report)
    engine.send({ kind: 'heard' })
  })
  for (const order of orders) engine.send(order)
  const last = () => reports.findLast((one) => one.kind === 'progress')
  await vi.waitFor(() => expect(last()).toMatchObject({ round: 60, isGoing: false }))
  engine.close()
  return [...last()!.now]
}

afterEach(() => vi.unstubAllGlobals())

test('where there is no worker, or it is killed, the page practises to the same bits', async () => {
  vi.stubGlobal('Worker', undefined)
  const alone = await practised()
  for (const most of [0, 1]) {
    vi.stubGlobal('Worker', dyingAfter(most))
    expect(await practised()).toEqual(alone)
  }
})

test('a question about a table is answered by the page where the worker is killed', async () => {
  vi.stubGlobal('Worker', dyingAfter(0))
  const answers: Report[] = []
  const engine = new Engine((report) => answers.push(report))
  const pairs = [{ row: 0, drive: 0, inputs: [20], outputs: [80] }]
  const table = { pairs, inputs: ['eye'], outputs: ['wheel'], wheels: null, mirror: null, knobs: 4 }
  engine.send({ kind: 'ask', number: 7, table })
  const findings = [{ kind: 'few', rows: 1, isMirrored: false, knobs: 4 }]
  await vi.waitFor(() => expect(answers).toEqual([{ kind: 'answer', number: 7, findings }]))
  engine.close()
})
