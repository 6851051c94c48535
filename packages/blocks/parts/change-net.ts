import type { Block, Definition } from '../types.ts'
import { field } from './fields.ts'
import { biasIn, setWeight, weightIn } from './nets.ts'
import { ask, done, fail } from './next.ts'
import { numberAt } from './numbers.ts'
import type { Python, PythonAt } from '../python.ts'
import { afterAsking } from './steps.ts'

/** CHANGE INCR adds to what is there; SET, and blocks without CHANGE, put VALUE in its place. */
const kept = (block: Block, now: number) => (field(block, 'CHANGE', 'SET') === 'INCR' ? now : 0)

/** Gives the link FROM → TO the weight VALUE, or adds it. Errors: noSuchNeuron. */
export const changeWeight: Definition['run'] = afterAsking([ask('VALUE')], (frame, context, block) => {
  const from = field(block, 'FROM')
  const to = field(block, 'TO')
  const now = weightIn(context, from, to)
  if (now === null) return fail('noSuchNeuron', { name: `${from} → ${to}` })
  setWeight(context, from, to, kept(block, now) + numberAt(frame, 0))
  return done
})

/** Gives the neuron NAME the bias VALUE, or adds it. Errors: noSuchNeuron. */
export const changeBias: Definition['run'] = afterAsking([ask('VALUE')], (frame, context, block) => {
  const name = field(block, 'NAME')
  const now = biasIn(context, name)
  if (now === null) return fail('noSuchNeuron', { name })
  context.memory.net().biases[name] = kept(block, now) + numberAt(frame, 0)
  return done
})

const change = (py: PythonAt, place: string) =>
  py.line(`${place} ${py.field('CHANGE', 'SET') === 'INCR' ? '+=' : '='} ${py.value('VALUE')}`)

export const pythonWeight: Python = (py) => change(py, py.neuron('weights', py.field('FROM'), py.field('TO')))

export const pythonBias: Python = (py) => change(py, py.neuron('biases', py.field('NAME')))
