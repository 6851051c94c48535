import { blockFrom, type Template } from '@botgarten/blocks'
import type { Program } from '../types.ts'

/** Templates for tests: `block('type', {FIELD}, {INPUT}, {STATEMENTS})`. */
export function block(
  type: string,
  fields: Template['fields'] = {},
  values: Template['values'] = {},
  statements: Template['statements'] = {},
): Template {
  return { type, fields, values, statements }
}

export const number = (x: number): Template => block('math_number', { NUM: String(x) })
export const distance = (port = '2'): Template =>
  block('robSensors_ultrasonic_getSample', { SENSORPORT: port })
export const forever = (...rows: Template[]): Template =>
  block('robControls_loopForever', {}, {}, { DO: rows })
export const repeat = (times: Template, ...rows: Template[]): Template =>
  block('controls_repeat_ext', {}, { TIMES: times }, { DO: rows })
export const wait = (ms: number): Template => block('robControls_wait_time', {}, { WAIT: number(ms) })
export const lamp = (colour: 'GREEN' | 'RED'): Template =>
  block('actions_bricklight_on_ev3', { COLOUR: colour, MODE: 'ON' })
export const show = (out: Template): Template =>
  block('robActions_display_text', {}, { OUT: out, COL: number(0), ROW: number(0) })
export const calculate = (operator: string, a: Template, b: Template): Template =>
  block('math_arithmetic', { OP: operator }, { A: a, B: b })
export const compare = (operator: string, a: Template, b: Template): Template =>
  block('logic_compare', { OP: operator }, { A: a, B: b })
export const colour = (value: string): Template => block('robColour_picker', { COLOUR: value })

const layer = (listType: 'InputNode' | 'OutputNode', rows: readonly (Template | null)[]): Template => ({
  type: 'ai_easy_list',
  mutation: { attrs: { items: String(rows.length), list_type: listType } },
  values: Object.fromEntries(rows.flatMap((row, k) => (row ? [[`ADD${k}`, row]] : []))),
})

export const net = (inputs: readonly (Template | null)[], outputs: readonly (Template | null)[]): Template =>
  block(
    'ai_neural_network',
    {},
    { INPUT_LAYER: layer('InputNode', inputs), OUTPUT_LAYER: layer('OutputNode', outputs) },
  )

export const start: Template = block('robControls_start')

/** A program of stacks; ids are `type` or `type#2`, in reading order. */
export function programOf(...stacks: readonly (readonly Template[])[]): Program {
  const seen = new Map<string, number>()
  const plant = (template: Template) => {
    const names = namesOf(template).map((type) => {
      const count = (seen.get(type) ?? 0) + 1
      seen.set(type, count)
      return count === 1 ? type : `${type}#${count}`
    })
    return blockFrom(template, () => names.shift() ?? '')
  }
  return {
    stacks: stacks.map((rows) => ({ x: 0, y: 0, blocks: rows.map(plant) })),
    config: { stacks: [] },
  }
}

const namesOf = (template: Template): string[] => [
  template.type,
  ...Object.values(template.values ?? {}).flatMap(namesOf),
  ...Object.values(template.statements ?? {}).flatMap((rows) => rows.flatMap(namesOf)),
]
