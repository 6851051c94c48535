import sax from 'sax'
import { ProjectError } from '../project/error.ts'
import { isReserved, refuseBigText } from '../project/limits.ts'
import { isAttribute, isWhole, namespace } from './xml.ts'

/** An element of an Open Roberta file. `text` is its own text, of its children's nothing. */
export interface Element {
  readonly name: string
  readonly attributes: { readonly [name: string]: string }
  readonly children: Element[]
  text: string
}

/**
 * Elements inside elements. A block in another takes two or three; as data of a project, which may have 600 levels, two
 * or three as well.
 */
const deepest = 920
const mostBlocks = 10_000
const mostElements = 20 * mostBlocks
/** Blocks of Open Roberta have some ten. The parser's time grows with the square of those of one element. */
const mostAttributes = 1000
/** So many letters between two looks at how many attributes an element has so far. */
const portion = 65_536

/**
 * A document as a tree, by a strict parser: no document type, so no entities of its own; one namespace; limits on size,
 * depth and number.
 * @throws {ProjectError} and nothing else
 */
export function treeOf(text: string): Element {
  refuseBigText(text)
  const builder = new Builder()
  try {
    builder.read(text.replace(/\r\n?/g, '\n'))
  } catch (error) {
    if (error instanceof ProjectError) throw error
    throw builder.notXml()
  }
  if (!builder.root) throw builder.notXml()
  return builder.root
}

/** No entities but those of XML itself, of which the types of the parser do not know. */
const options: sax.SAXOptions & { readonly strictEntities: true } = { xmlns: true, strictEntities: true }

/** What the types of the parser leave out: the attributes so far of an element that is being read. */
interface Inside {
  readonly attribList: readonly unknown[]
  bufferCheckPosition: number
}

class Builder {
  readonly parser = sax.parser(true, options)
  root: Element | null = null
  readonly #open: Element[] = []
  #blocks = 0
  #elements = 0

  constructor() {
    const { parser } = this
    parser.onerror = () => {
      throw this.notXml()
    }
    parser.ondoctype = () => {
      throw new ProjectError('unsafeXml', 'It declares a document type; programs have none.')
    }
    parser.onattribute = ({ name, value }) => {
      if (!isWhole(value)) throw this.notXml()
      if (isReserved(name)) throw notOpenRoberta(`An attribute must not be called "${name}".`)
    }
    parser.onopentag = (tag) => this.#begin(tag as sax.QualifiedTag)
    parser.onclosetag = () => void this.#open.pop()
    parser.ontext = (text) => this.#say(text)
    parser.oncdata = (text) => this.#say(text)
  }

  read(text: string): void {
    const inside = this.parser as unknown as Inside
    // Else it would cut long texts between two portions.
    inside.bufferCheckPosition = Infinity
    for (let at = 0; at < text.length; at += portion) {
      this.parser.write(text.slice(at, at + portion))
      if (inside.attribList.length > mostAttributes)
        throw notOpenRoberta('One element has too many attributes.')
    }
    this.parser.close()
  }

  notXml(): ProjectError {
    const line = this.parser.line + 1
    return new ProjectError('notXml', `This is not XML: line ${line}.`, { line })
  }

  #begin({ local, uri, attributes }: sax.QualifiedTag): void {
    if (uri !== '' && uri !== namespace) throw notOpenRoberta(`"${local}" is of another namespace.`)
    this.#count(local)
    const own = Object.values(attributes)
      .filter(({ name, value }) => isAttribute(name, value))
      .map(({ name, value }) => [name, value] as const)
    const element = { name: local, attributes: Object.fromEntries(own), children: [], text: '' }
    this.#open.at(-1)?.children.push(element)
    this.root ??= element
    this.#open.push(element)
  }

  #count(name: string): void {
    if (name === 'block' || name === 'shadow') this.#blocks++
    if (this.#blocks > mostBlocks || ++this.#elements > mostElements)
      throw new ProjectError('tooManyBlocks', `It has more than ${mostBlocks} blocks.`, { most: mostBlocks })
    if (this.#open.length >= deepest) throw new ProjectError('tooDeep', 'It is nested too deeply.')
  }

  #say(text: string): void {
    if (!isWhole(text)) throw this.notXml()
    const element = this.#open.at(-1)
    if (element) element.text += text
  }
}

export const notOpenRoberta = (why: string) => new ProjectError('notOpenRoberta', why)
