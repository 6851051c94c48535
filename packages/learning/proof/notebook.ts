import type { Part, Proof } from './types.ts'

interface Cell {
  readonly cell_type: 'markdown' | 'code'
  readonly source: string
}

/**
 * A notebook (nbformat 4.5, JSON) that makes a number again: its data, what learns from them, the number, each after a text.
 * @param text what stands before a part, as Markdown
 */
export function notebookOf(proof: Proof, text: (part: Part) => string): string {
  const cells = [
    { cell_type: 'markdown', source: text('title') },
    ...[part('data', dataCell(proof)), part('learn', proof.learn), part('number', numberCell(proof))].flat(),
  ] satisfies Cell[]
  const whole = {
    nbformat: 4,
    nbformat_minor: 5,
    metadata: {
      kernelspec: { display_name: 'Python 3', language: 'python', name: 'python3' },
      language_info: { name: 'python' },
    },
    cells: cells.map(written),
  }
  return `${JSON.stringify(whole, null, 1)}\n`

  function part(name: Part, source: string): Cell[] {
    return [
      { cell_type: 'markdown', source: text(name) },
      { cell_type: 'code', source },
    ]
  }
}

/** One entry a line: a notebook is read by people, too. */
function dataCell({ data, number }: Proof): string {
  const entries = Object.entries({ ...data, shown: number })
  const lines = entries.map(([name, value]) => `${JSON.stringify(name)}: ${JSON.stringify(value)}`)
  return `import json
import numpy as np

data = json.loads("""{
${lines.join(',\n')}
}""")`
}

const numberCell = ({ show }: Proof): string => `${show}
print(float(number))
assert abs(number - data["shown"]) <= 1e-9 * max(1, abs(data["shown"]))`

function written({ cell_type, source }: Cell, at: number) {
  const lines = source.split('\n')
  const cell = {
    cell_type,
    id: `cell-${at}`,
    metadata: {},
    source: lines.map((line, k) => (k < lines.length - 1 ? `${line}\n` : line)),
  }
  return cell_type === 'code' ? { ...cell, execution_count: null, outputs: [] } : cell
}
