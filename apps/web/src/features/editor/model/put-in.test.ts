import type { Block } from '@botgarten/blocks'
import { networksByUse } from '@botgarten/programs'
import { afterEach, describe, expect, it } from 'vitest'
import { putIn, putNetworkIn, switchOn } from './put-in.ts'
import { Bench, distance, motor, network } from './test-bench.ts'

let bench: Bench
afterEach(() => bench.dispose())

const net = () => network([distance('eye', '2')], [motor('wheel', 'C')])
const start: Block = { id: 'start', type: 'robControls_start' }
const wait = (id: string): Block => ({ id, type: 'robControls_wait_time' })
const forever = (id: string, ...blocks: readonly Block[]): Block => ({
  id,
  type: 'robControls_loopForever',
  statements: { DO: blocks },
})

/** A row as ids, what stands in a block in brackets behind it; of what is made again the type. */
const told = (row: readonly Block[]): string =>
  row
    .map(({ id, type, statements }) => {
      const inside = Object.values(statements ?? {}).flat()
      const name = /^[a-z]{2,8}\d?$/.test(id) ? id : type.replace('robControls_', 'new ')
      return inside.length > 0 ? `${name}(${told(inside)})` : name
    })
    .join(' ')
const stacks = () => bench.program().stacks.map(({ blocks }) => told(blocks))
const put = (id = 'net') => {
  putIn(bench.workspace, bench.program(), id)
  bench.settle()
}

function benchOf(...rows: readonly (readonly Block[])[]) {
  bench = new Bench(...(rows[0] ?? []))
  for (const row of rows.slice(1)) bench.adds(...row)
}

describe('a network that is put in', () => {
  it('goes to the end of the loop, with one step of undo', () => {
    benchOf([start, forever('loop', wait('first'))], [net()])
    const before = bench.program()
    put()
    expect(stacks()).toEqual(['start loop(first net)'])
    bench.undo()
    expect(bench.program()).toEqual(before)
    bench.redo()
    expect(stacks()).toEqual(['start loop(first net)'])
  })

  it('takes what hangs with it along', () => {
    benchOf([start, forever('loop')], [wait('before'), net(), wait('after')])
    put()
    expect(stacks()).toEqual(['start loop(before net after)'])
  })

  it('gets a loop where there is none, and a start block', () => {
    benchOf([start, wait('first')], [net()])
    put()
    expect(stacks()).toEqual(['start first new loopForever(net)'])
    bench.dispose()
    benchOf([net()])
    const before = bench.program()
    put()
    expect(stacks()).toEqual(['new start new loopForever(net)'])
    bench.undo()
    expect(bench.program()).toEqual(before)
  })

  it('brings the loop it stands in', () => {
    benchOf([start, wait('first')], [forever('loop', net())])
    put()
    expect(stacks()).toEqual(['start first loop(net)'])
  })

  it('switches a start block on that is switched off', () => {
    benchOf([{ ...start, disabled: true }, forever('loop', net())])
    put()
    expect(networksByUse(bench.program())[0]!.idle).toBe(null)
    expect(stacks()).toEqual(['start loop(net)'])
  })

  it('comes from behind a loop that never ends alone', () => {
    benchOf([start, forever('loop'), wait('between'), net(), wait('last')])
    put()
    expect(stacks()).toEqual(['start loop(net) between last'])
  })

  it('runs then, wherever it hung', () => {
    const hung: readonly (readonly (readonly Block[])[])[] = [
      [[start], [net()]],
      [[start, forever('outer', forever('inner', wait('one')))], [net()]],
      [
        [start, { id: 'twice', type: 'controls_repeat_ext' }],
        [wait('one'), forever('loop', net())],
      ],
      [[start, forever('loop', wait('one')), net()]],
      [[net()], [{ ...start, disabled: true }]],
    ]
    for (const rows of hung) {
      benchOf(...rows)
      put()
      expect(
        networksByUse(bench.program()).map(({ idle }) => idle),
        JSON.stringify(rows),
      ).toEqual([null])
      if (rows !== hung.at(-1)) bench.dispose()
    }
  })
})

describe('a network from the toolbox', () => {
  it('is made in the loop, and gone with one step of undo', () => {
    benchOf([start, forever('loop')])
    const before = bench.program()
    const id = putNetworkIn(bench.workspace, before)
    bench.settle()
    expect(networksByUse(bench.program())).toMatchObject([{ id, idle: null }])
    bench.undo()
    expect(bench.program()).toEqual(before)
  })
})

describe('the network of a card', () => {
  const wanted = {
    inputs: [{ type: 'ai_nn_input_node_coloursensor_light', fields: { SENSORPORT: '1' } }],
    outputs: ['A', 'B'].map((word) => ({ type: 'ai_nn_output_node_text', fields: { OUTPUTNODE: word } })),
  }
  const neurons = () => {
    const { inputs, outputs } = networksByUse(bench.program())[0]!
    return [inputs, outputs].map((layer) => layer.map(({ type, fields }) => ({ type, fields })))
  }

  it('is made below the block that the card names, with its neurons, and gone with one step of undo', () => {
    benchOf([start, forever('loop', forever('inner', wait('drive'), wait('more')), wait('turn'))])
    const before = bench.program()
    putNetworkIn(bench.workspace, before, { ...wanted, below: 'drive' })
    bench.settle()
    expect(stacks()).toEqual(['start loop(inner(drive ai_neural_network more) turn)'])
    expect(neurons()).toEqual([wanted.inputs, wanted.outputs])
    bench.undo()
    expect(bench.program()).toEqual(before)
  })

  it('is made in the loop where that block is gone or runs no more, or the card names none', () => {
    for (const below of ['gone', 'aside', undefined]) {
      benchOf([start, forever('loop', wait('drive'))], [wait('aside')])
      putNetworkIn(bench.workspace, bench.program(), { ...wanted, ...(below && { below }) })
      bench.settle()
      expect(stacks()[0]).toBe('start loop(drive ai_neural_network)')
      expect(neurons()).toEqual([wanted.inputs, wanted.outputs])
      if (below) bench.dispose()
    }
  })
})

it('a network is switched on with what it stands in', () => {
  benchOf([start, { ...forever('loop', { ...net(), disabled: true }), disabled: true }])
  const before = bench.program()
  switchOn(bench.workspace, 'net')
  bench.settle()
  expect(networksByUse(bench.program())[0]!.idle).toBe(null)
  bench.undo()
  expect(bench.program()).toEqual(before)
})

it('blocks of learning by trying go below the start block', () => {
  const map: Block = { id: 'map', type: 'ai_q_learning_states_and_actions_map' }
  benchOf([start, forever('loop')], [map, wait('after')])
  put('map')
  expect(stacks()).toEqual(['start map after loop'])
})
