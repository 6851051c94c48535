import sax from 'sax'

type Tree = readonly [
  name: string,
  attributes: readonly (readonly [string, string])[],
  inside: readonly (Tree | string)[],
]

/** Where white space counts. */
const holdsText = / (field|comment|data|error|warning)$/

/**
 * An XML document as comparable data, read apart from the product's own reader: names with their namespaces, attributes
 * in the order of their names, no white space between elements.
 */
export function xmlTree(text: string): Tree {
  const parser = sax.parser(true, { xmlns: true })
  const open: [string, [string, string][], (Tree | string)[]][] = [['', [], []]]
  parser.onopentag = (tag) => {
    const { uri, local, attributes } = tag as sax.QualifiedTag
    const own = Object.values(attributes).map(({ name, value }): [string, string] => [name, value])
    const element: (typeof open)[number] = [
      `${uri} ${local}`,
      own.filter(([name]) => name !== 'xmlns').sort(),
      [],
    ]
    open.at(-1)![2].push(element)
    open.push(element)
  }
  parser.onclosetag = () => {
    const [name, , inside] = open.pop()!
    if (holdsText.test(name)) return
    inside.splice(0, Infinity, ...inside.filter((part) => typeof part !== 'string' || part.trim() !== ''))
  }
  parser.ontext = parser.oncdata = (piece) => {
    const inside = open.at(-1)![2]
    if (typeof inside.at(-1) === 'string') inside.push(`${inside.pop() as string}${piece}`)
    else inside.push(piece)
  }
  parser.write(text.replace(/\r\n?/g, '\n')).close()
  return open[0]![2].find((part): part is Tree => typeof part !== 'string')!
}
