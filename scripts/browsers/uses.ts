// Which APIs of JavaScript and of the web our scripts use: TypeScript's checker finds the declaration of each name.
import { existsSync } from 'node:fs'
import { relative } from 'node:path'
import ts from 'typescript'
import type { Tree } from './support.mjs'

/** A use of an API: where the table of MDN has it, and where it is used. */
export interface Use {
  /** Such as `URL.parse`. */
  readonly name: string
  /**
   * Such as `api.URL.parse_static`. A member of a mixin has an entry for each interface that may have it: which one it is the
   * checker does not say. None: the table does not know it.
   */
  readonly paths: readonly string[]
  /** Paths of files. */
  readonly places: readonly string[]
}

const isLib = (file: string) => /[\\/]typescript[\\/]lib[\\/]lib\.[\w.]+\.d\.ts$/.test(file)
const isLibOfJavaScript = (file: string) => /[\\/]lib\.(es|decorators)[\w.]*\.d\.ts$/.test(file)

/** Interfaces of TypeScript that the table has under the name of the object they describe. */
const describes: { readonly [name: string]: string } = {
  ReadonlyArray: 'Array',
  ConcatArray: 'Array',
  ReadonlyMap: 'Map',
  ReadonlySet: 'Set',
  IteratorObject: 'Iterator',
  IterableIterator: 'Iterator',
  ArrayIterator: 'Iterator',
  MapIterator: 'Iterator',
  SetIterator: 'Iterator',
  CallableFunction: 'Function',
  NewableFunction: 'Function',
  RegExpMatchArray: 'Array',
  RegExpExecArray: 'Array',
  // Members of Intl's own objects.
  NumberFormat: 'Intl.NumberFormat',
  PluralRules: 'Intl.PluralRules',
  ListFormat: 'Intl.ListFormat',
  RelativeTimeFormat: 'Intl.RelativeTimeFormat',
  DateTimeFormat: 'Intl.DateTimeFormat',
  Collator: 'Intl.Collator',
}

/** Entries by name, and below them their members. */
interface Entries {
  readonly [name: string]: object
}

/** Looks names up in the table. */
export class Lookup {
  readonly #table: { readonly api: Entries; readonly javascript: { readonly builtins: Entries } }
  readonly #has: (path: string) => boolean
  readonly #interfaces: readonly string[]

  /** @param has whether the table has an entry there */
  constructor(table: Tree, has: (path: string) => boolean) {
    this.#table = table as never
    this.#has = has
    this.#interfaces = Object.keys(this.#table.api)
  }

  /** Names with an entry for which this holds; the checker resolves no others, which would take minutes. */
  namesWhere(holds: (entry: object) => boolean): ReadonlySet<string> {
    const { api, javascript } = this.#table
    const names = [...Object.entries(api), ...Object.entries(javascript.builtins)].flatMap(
      ([owner, members]) => [
        ...(holds(members) ? [owner] : []),
        ...Object.entries(members)
          .filter(([, entry]) => holds(entry as object))
          .map(([name]) => name.replace(/_static$/, '').replace(/^(\w+)_event$/, 'on$1')),
      ],
    )
    return new Set(names)
  }

  /** A member of an interface; for one of a mixin the interfaces that may have it. */
  member(owner: string, member: string, isJavaScript: boolean): readonly string[] {
    if (isJavaScript) {
      const name = owner.replace(/Constructor$/, '')
      const described = describes[name] ?? name
      const owners = [
        described,
        ...(/^(Ui|I)nt\d+|^Float\d+|^Big(Ui|I)nt64/.test(described) ? ['TypedArray'] : []),
      ]
      return owners
        .map((one) => `javascript.builtins.${one}.${member}`)
        .filter(this.#has)
        .slice(0, 1)
    }
    const names = member.startsWith('on') ? [`${member.slice(2)}_event`] : [member, `${member}_static`]
    const own = names.map((name) => `api.${owner}.${name}`).filter(this.#has)
    if (own.length > 0) return own.slice(0, 1)
    // A member of a mixin, or one that the interface inherits.
    return this.#interfaces.flatMap((one) => names.map((name) => `api.${one}.${name}`)).filter(this.#has)
  }

  global(name: string): readonly string[] {
    return [`javascript.builtins.${name}`, `api.${name}`, `api.Window.${name}`].filter(this.#has).slice(0, 1)
  }
}

/** Reads as a value: names in types are gone when the page runs. */
function isInType(node: ts.Node): boolean {
  for (let at: ts.Node | undefined = node; at; at = at.parent) {
    if (ts.isTypeNode(at) || ts.isInterfaceDeclaration(at) || ts.isTypeAliasDeclaration(at)) return true
    if (ts.isStatement(at) || ts.isArrowFunction(at)) return false
  }
  return false
}

/** Where the checker finds a name declared: `[owner, member]`, or `[name]` of a global one. */
function declaredAs(declaration: ts.Declaration, name: string): readonly string[] | null {
  const { parent } = declaration
  if (name === 'prototype') return null
  if (ts.isInterfaceDeclaration(parent)) return [parent.name.text, name]
  if (ts.isTypeLiteralNode(parent) && ts.isVariableDeclaration(parent.parent))
    return [parent.parent.name.getText(), name]
  const scope = ts.isVariableDeclarationList(parent) ? parent.parent.parent : parent
  if (ts.isSourceFile(scope)) return [name]
  // `Intl`.
  return ts.isModuleBlock(scope) ? [scope.parent.name.text, name] : null
}

interface Search {
  /** Does a file run in a browser? */
  readonly isOurs: (file: string) => boolean
  /** The folder that `places` are relative to. */
  readonly house: string
  readonly lookup: Lookup
  /** Names to search for. */
  readonly names: ReadonlySet<string>
}

/**
 * APIs that files of a program use.
 * @param config its tsconfig.json
 * @throws Error if there is no such configuration
 */
export function usesIn(config: string, { isOurs, house, lookup, names }: Search): readonly Use[] {
  if (!existsSync(config)) throw new Error(`There is no ${config}: npm run types:web writes it.`)
  const host = {
    ...ts.sys,
    onUnRecoverableConfigFileDiagnostic({ messageText }: ts.Diagnostic) {
      throw new Error(ts.flattenDiagnosticMessageText(messageText, '\n'))
    },
  }
  const { fileNames, options } = ts.getParsedCommandLineOfConfigFile(config, {}, host)!
  const program = ts.createProgram(
    fileNames.filter((file) => !/\.test\.ts$/.test(file)),
    options,
  )
  const checker = program.getTypeChecker()
  const found = new Map<string, { paths: readonly string[]; places: Set<string> }>()

  function note(name: string, paths: readonly string[], node: ts.Node) {
    const file = node.getSourceFile()
    const use = found.get(name) ?? { paths, places: new Set<string>() }
    use.places.add(placeOf(relative(house, file.fileName)))
    found.set(name, use)
  }

  function visit(node: ts.Node): void {
    if (ts.isIdentifier(node) && names.has(node.text) && !isInType(node)) {
      const symbol = checker.getSymbolAtLocation(node)
      const all = symbol?.declarations?.filter((one) => isLib(one.getSourceFile().fileName)) ?? []
      // A name that our own files declare as well is not an API.
      const [first] = all.length === symbol?.declarations?.length ? all : []
      const declared = first && declaredAs(first, symbol!.name)
      if (declared) {
        const [owner, member] = declared
        const isJavaScript = isLibOfJavaScript(first.getSourceFile().fileName)
        const paths = member ? lookup.member(owner!, member, isJavaScript) : lookup.global(owner!)
        note(declared.join('.'), paths, node)
      }
    }
    ts.forEachChild(node, visit)
  }
  for (const file of program.getSourceFiles())
    if (!file.isDeclarationFile && isOurs(relative(house, file.fileName))) visit(file)
  return [...found]
    .map(([name, { paths, places }]) => ({ name, paths, places: [...places].toSorted() }))
    .toSorted((a, b) => (a.name < b.name ? -1 : 1))
}

/** svelte-check writes the script of a component next to its other files. */
const placeOf = (file: string) =>
  file.replace(/\.svelte-kit\/\.svelte-check\/svelte\/(.*)\+\+(\w+\.svelte)\.ts$/, '$1$2')
