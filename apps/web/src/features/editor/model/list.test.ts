import * as Blockly from 'blockly/core'
import fc from 'fast-check'
import { afterEach, describe, expect, it } from 'vitest'
import type { BotBlock } from './bot-block.ts'
import { watchCopies, type Copy } from './copies.ts'
import { followNeurons } from '../view/follow.ts'
import { addLine, foot, linesOf, removeLine } from './list.ts'
import { addNeuron } from './network.ts'
import { Bench, distance, motor, network } from './test-bench.ts'

let bench: Bench
afterEach(() => bench.dispose())

const friendship = () =>
  (bench = new Bench(
    network([distance('eyeLeft', '2'), distance('eyeRight', '3')], [motor('left', 'C'), motor('right', 'B')]),
  ))

/** The ids of the neurons that the program has in a list, from the top; '' for an empty row. */
function rows(listId: string): string[] {
  const find = (block: (typeof all)[number]): typeof block | undefined =>
    block.id === listId
      ? block
      : Object.values(block.values ?? {})
          .map(find)
          .find(Boolean)
  const all = bench.program().stacks.flatMap(({ blocks }) => blocks)
  const list = all.map(find).find(Boolean)
  return Array.from(
    { length: Number(list?.mutation?.attrs['items']) },
    (_, at) => list?.values?.[`ADD${at}`]?.id ?? '',
  )
}

describe('the plus of a list', () => {
  it('adds one more of the last kind, at the next free port', () => {
    friendship()
    const added = addLine(bench.block('inputs'))!
    expect(rows('inputs')).toEqual(['eyeLeft', 'eyeRight', added.id])
    expect(added.getFieldValue('INPUTNODE')).toBe('ULTRASONIC_PORT_4')
  })

  it('goes round to the first port and does not take one that is used', () => {
    bench = new Bench(network([distance('a', '4'), distance('b', '1')], [motor('m', 'D')]))
    expect(addLine(bench.block('inputs'))!.getFieldValue('INPUTNODE')).toBe('ULTRASONIC_PORT_2')
    expect(addLine(bench.block('outputs'))!.getFieldValue('OUTPUTNODE')).toBe('MOTORPORT_A')
  })

  it('adds the next colour to colours', () => {
    const green = { id: 'g', type: 'ai_nn_output_node_led', fields: { OUTPUTNODE: '#00642E' } }
    bench = new Bench(network([distance('a', '2')], [green]))
    const added = addLine(bench.block('outputs'))!
    expect([added.type, added.getFieldValue('OUTPUTNODE')]).toEqual(['ai_nn_output_node_led', '#F7D118'])
  })

  it('is one step of undo', () => {
    friendship()
    const before = bench.program()
    addLine(bench.block('inputs'))
    bench.settle()
    bench.undo()
    expect(bench.program()).toEqual(before)
  })
})

describe('a list that is rebuilt', () => {
  it('has one empty row for a neuron, with a pointed plug where it is a layer of a deeper network', () => {
    friendship()
    expect(linesOf(bench.workspace.newBlock('ai_easy_list') as BotBlock)).toEqual(['ADD0'])
    bench.adds({ id: 'hidden', type: 'ai_nn_hidden_layer' })
    expect(bench.block('hidden').frame).toEqual({ plug: 'pointed', tint: 'hidden' })
    expect(bench.block('eyeLeft').frame).toBeNull()
  })
})

describe('the minus of a row', () => {
  it('takes the neuron of its row and leaves the ids of the others', () => {
    friendship()
    removeLine(bench.block('inputs'), linesOf(bench.block('inputs'))[0]!)
    expect(rows('inputs')).toEqual(['eyeRight'])
  })

  it('empties the last row that a list must keep', () => {
    bench = new Bench(network([distance('eye', '2')], [motor('m', 'C')]))
    removeLine(bench.block('inputs'), linesOf(bench.block('inputs'))[0]!)
    expect(rows('inputs')).toEqual([''])
  })
})

describe('undo and redo', () => {
  type Edit = { list: 'inputs' | 'outputs' } & ({ kind: 'add' } | { kind: 'remove' | 'turn'; at: number })
  const at = fc.nat(5)
  const edit: fc.Arbitrary<Edit> = fc
    .tuple(
      fc.constantFrom('inputs' as const, 'outputs' as const),
      fc.oneof(
        fc.record({ kind: fc.constant('add' as const) }),
        fc.record({ kind: fc.constantFrom('remove' as const, 'turn' as const), at }),
      ),
    )
    .map(([list, rest]) => ({ list, ...rest }))

  function execute(edit: Edit) {
    const list = bench.block(edit.list)
    if (edit.kind === 'add') return void addLine(list)
    const lines = linesOf(list)
    const line = lines[edit.at % lines.length]!
    if (edit.kind === 'remove') return removeLine(list, line)
    const neuron = list.getInputTargetBlock(line)
    const name = edit.list === 'inputs' ? 'INPUTNODE' : 'OUTPUTNODE'
    neuron?.setFieldValue(edit.list === 'inputs' ? 'ULTRASONIC_PORT_1' : 'MOTORPORT_A', name)
  }

  it('go back and forth through any work on the lists, ids and all', () => {
    fc.assert(
      fc.property(fc.array(edit, { maxLength: 8 }), (edits) => {
        friendship()
        const states = [bench.program()]
        for (const edit of edits) {
          execute(edit)
          bench.settle()
          if (JSON.stringify(bench.program()) !== JSON.stringify(states.at(-1))) states.push(bench.program())
        }
        for (const state of states.slice(0, -1).reverse()) {
          bench.undo()
          expect(bench.program()).toEqual(state)
        }
        for (const state of states.slice(1)) {
          bench.redo()
          expect(bench.program()).toEqual(state)
        }
        bench.dispose()
      }),
      { numRuns: 60 },
    )
    friendship()
  })
})

describe('lists follow the hand', () => {
  let held = false
  function watched() {
    friendship()
    held = false
    bench.workspace.addChangeListener(followNeurons(bench.workspace, () => held))
  }
  const release = () => {
    held = false
    bench.workspace.fireChangeListener(new (Blockly.Events.get(Blockly.Events.CLICK))())
    bench.settle()
  }

  it('a neuron dropped on the foot gets a row of its own', () => {
    watched()
    const neuron = bench.workspace.newBlock('ai_nn_input_node_coloursensor_light')
    bench.block('inputs').getInput(foot)!.connection!.connect(neuron.outputConnection!)
    bench.settle()
    expect(rows('inputs')).toEqual(['eyeLeft', 'eyeRight', neuron.id])
  })

  it('the row that a neuron was taken from closes when the hand lets go, not before', () => {
    watched()
    held = true
    bench.block('eyeLeft').unplug()
    bench.settle()
    expect(rows('inputs')).toEqual(['', 'eyeRight'])
    release()
    expect(rows('inputs')).toEqual(['eyeRight'])
  })

  it('a neuron that is put back keeps its row', () => {
    watched()
    held = true
    const socket = bench.block('inputs').getInput('ADD0')!.connection!
    bench.block('eyeLeft').unplug()
    bench.settle()
    socket.connect(bench.block('eyeLeft').outputConnection!)
    bench.settle()
    release()
    expect(rows('inputs')).toEqual(['eyeLeft', 'eyeRight'])
  })

  it('undo brings the row back with its neuron', () => {
    watched()
    const before = bench.program()
    Blockly.Events.setGroup(true)
    bench.block('eyeLeft').dispose(false)
    Blockly.Events.setGroup(false)
    bench.settle()
    expect(rows('inputs')).toEqual(['eyeRight'])
    bench.undo()
    expect(bench.program()).toEqual(before)
  })
})

describe('a neuron from the playground', () => {
  const light = { type: 'ai_nn_input_node_coloursensor_light', fields: { SENSORPORT: '1' } }

  it('comes into a new row of its layer', () => {
    friendship()
    const id = addNeuron(bench.workspace, 'net', 'input', light)
    expect(rows('inputs')).toEqual(['eyeLeft', 'eyeRight', id])
  })

  it('is one more of its kind where none is named', () => {
    friendship()
    const id = addNeuron(bench.workspace, 'net', 'input')!
    expect(bench.block(id).getFieldValue('INPUTNODE')).toBe('ULTRASONIC_PORT_4')
  })

  it('comes into an empty row first', () => {
    friendship()
    bench.block('eyeLeft').dispose(false)
    const id = addNeuron(bench.workspace, 'net', 'input', light)
    expect(rows('inputs')).toEqual([id, 'eyeRight'])
  })

  it('brings its list along where there is none', () => {
    friendship()
    bench.block('outputs').dispose(false)
    const id = addNeuron(bench.workspace, 'net', 'output', { type: 'ai_nn_output_node_sound' })
    const list = bench.block('net').getInputTargetBlock('OUTPUT_LAYER')!
    expect(rows(list.id)).toEqual([id])
  })

  it('is refused where there is no such network', () => {
    friendship()
    expect(addNeuron(bench.workspace, 'gone', 'input', light)).toBeNull()
  })
})

describe('copies', () => {
  function pairsOf(copy: () => void): readonly Copy[] {
    const pairs: Copy[] = []
    const among = watchCopies(bench.workspace)
    bench.workspace.addChangeListener((event) => void pairs.push(...among(event)))
    copy()
    bench.settle()
    return pairs
  }
  const stateOf = (id: string) => Blockly.serialization.blocks.save(bench.block(id), { saveIds: false })!
  const paste = (state: Blockly.serialization.blocks.State) =>
    Blockly.serialization.blocks.append(state, bench.workspace, { recordUndo: true })

  it('of a list are told neuron by neuron, old id and new', () => {
    friendship()
    const pairs = pairsOf(() => paste(stateOf('inputs')))
    expect(pairs.map(({ from }) => from)).toEqual(['eyeLeft', 'eyeRight'])
    expect(pairs.every(({ to }) => bench.workspace.getBlockById(to))).toBe(true)
  })

  it('are told after their original was cut', () => {
    friendship()
    const state = stateOf('eyeLeft')
    const pairs = pairsOf(() => {
      bench.block('eyeLeft').dispose(false)
      bench.settle()
      paste(state)
    })
    expect(pairs.map(({ from }) => from)).toEqual(['eyeLeft'])
  })

  it('of blocks that never stood on the workspace are none', () => {
    friendship()
    const state = stateOf('eyeLeft')
    const foreign = { ...state, extraState: { ...(state.extraState as object), self: 'onTheShelf' } }
    expect(pairsOf(() => paste(foreign))).toEqual([])
  })
})
