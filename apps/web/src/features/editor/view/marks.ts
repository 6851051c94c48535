import * as Blockly from 'blockly/core'

/** What is shown at blocks while a child looks closely: stop points, and texts of values. By the ids of blocks. */
export interface Marks {
  readonly stops: readonly string[]
  readonly values: ReadonlyMap<string, string>
}

interface Shown {
  readonly stop?: SVGElement
  readonly value?: {
    readonly group: SVGElement
    readonly text: SVGElement
    readonly plate: SVGElement
    said: string
  }
}

const shown = new WeakMap<Blockly.BlockSvg, Shown>()
const svg = Blockly.utils.dom.createSvgElement
/** Width of a character of the value's letters, in units of the workspace. */
const character = 8.2
const longest = 24

/** Puts marks where they belong and takes the others away. Changes only what has changed, and measures nothing. */
export function showMarks(workspace: Blockly.WorkspaceSvg, { stops, values }: Marks): void {
  const stopped = new Set(stops)
  for (const block of workspace.getAllBlocks(false)) {
    const before = shown.get(block) ?? {}
    const stop = stopMark(block, before.stop, stopped.has(block.id))
    const value = valueMark(block, before.value, values.get(block.id))
    if (stop !== before.stop || value !== before.value)
      shown.set(block, { ...(stop && { stop }), ...(value && { value }) })
  }
}

function stopMark(
  block: Blockly.BlockSvg,
  mark: SVGElement | undefined,
  wanted: boolean,
): SVGElement | undefined {
  if (wanted === (mark !== undefined)) return mark
  if (!wanted) return void mark?.remove()
  const group = svg('g', { class: 'editor-stop', transform: 'translate(-4 4)' }, block.getSvgRoot())
  svg('path', { d: 'M-5 -12H5L12 -5V5L5 12H-5L-12 5V-5Z' }, group)
  svg('path', { class: 'bar', d: 'M-5 0H5' }, group)
  return group
}

function valueMark(
  block: Blockly.BlockSvg,
  mark: Shown['value'],
  wanted: string | undefined,
): Shown['value'] {
  if (wanted === undefined) return void mark?.group.remove()
  const made = mark ?? freshValue(block)
  if (made.said === wanted) return made
  made.said = wanted
  const said = wanted.length > longest ? `${wanted.slice(0, longest - 1)}…` : wanted
  made.text.textContent = said
  made.plate.setAttribute('width', String(said.length * character + 14))
  return made
}

function freshValue(block: Blockly.BlockSvg): NonNullable<Shown['value']> {
  const at = `translate(${block.childlessWidth - 12} -12)`
  const group = svg('g', { class: 'editor-value', transform: at }, block.getSvgRoot())
  const plate = svg('rect', { height: 24, rx: 12 }, group)
  const text = svg('text', { x: 7, y: 17 }, group)
  return { group, plate, text, said: '' }
}
