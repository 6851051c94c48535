const ns = 'http://de.fhg.iais.roberta.blockly'
const value = (name: string, id: string, number: number) =>
  `<value name="${name}"><block type="math_number" id="${id}"><field name="NUM">${number}</field></block></value>`

const row = (id: string) =>
  `<block type="robActions_motorDiff_on_for" id="${id}"><field name="DIRECTION">FOREWARD</field>${value('DISTANCE', `${id}d`, 20)}${value('POWER', `${id}p`, 30)}</block>` +
  `<block type="robActions_display_clear" id="${id}c"></block>`

const times = <Value>(count: number, make: (k: number) => Value) =>
  Array.from({ length: count }, (_, k) => make(k))

const top = (k: number) =>
  k === 0
    ? '<block type="robControls_start" id="start"><mutation declare="false"></mutation></block>'
    : `<block type="robActions_motorDiff_stop" id="top${k}"></block>`

const loop = (inside: string) =>
  `<block type="robControls_loopForever" id="loop"><statement name="DO">${inside}</statement></block>`

/** A file of Open Roberta: stacks of `rows` times four blocks and one; `looped`: in the first they stand in a loop. */
export function bigFile(stacks: number, rows: number, looped = false): string {
  const stack = (k: number) => {
    const blocks = times(rows, (r) => row(`b${k}-${r}-`)).join('')
    return `<instance x="${40 + k * 420}" y="40">${top(k)}${looped && k === 0 ? loop(blocks) : blocks}</instance>`
  }
  return `<export xmlns="${ns}"><program><block_set xmlns="${ns}" robottype="ev3" xmlversion="3.1">${times(stacks, stack).join('')}</block_set></program></export>`
}
