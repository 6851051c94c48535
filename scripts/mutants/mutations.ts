import ts from 'typescript'

/** A file with one small fault. */
export interface Mutant {
  readonly file: string
  /** Counted from 1. */
  readonly line: number
  /** Names it in the list of equivalent ones: the line it is in and what changes, which survive edits elsewhere. */
  readonly was: string
  readonly change: string
  /** The whole file with the fault. */
  readonly text: string
}

interface Edit {
  readonly from: number
  readonly to: number
  readonly by: string
}

const swaps: { readonly [operator: string]: string } = {
  ...{ '+': '-', '-': '+', '*': '/', '/': '*', '%': '*', '**': '*' },
  ...{ '<': '<=', '<=': '<', '>': '>=', '>=': '>', '===': '!==', '!==': '===' },
  ...{ '&&': '||', '||': '&&', '??': '&&' },
  ...{ '+=': '-=', '-=': '+=', '*=': '/=', '??=': '=', '||=': '&&=', '&&=': '||=' },
  ...{ '&': '|', '|': '&', '^': '|', '<<': '>>', '>>': '<<', '>>>': '<<' },
}

const methods: { readonly [name: string]: string } = {
  ...{ min: 'max', max: 'min', floor: 'ceil', ceil: 'floor', every: 'some', some: 'every' },
  ...{ find: 'findLast', findLast: 'find', toSorted: 'toReversed', startsWith: 'endsWith' },
}

/** All faults that can be made in a file, in their order. */
export function mutantsOf(file: string, source: string): Mutant[] {
  const tree = ts.createSourceFile(file, source, ts.ScriptTarget.Latest, true)
  const edits: Edit[] = []
  const visit = (node: ts.Node): void => {
    if (isNoCode(node)) return
    edits.push(...editsOf(node, tree))
    ts.forEachChild(node, visit)
  }
  visit(tree)
  const names = new Map<string, number>()
  return edits
    .sort((a, b) => a.from - b.from || a.to - b.to)
    .map((edit) => {
      const made = mutant(file, source, tree, edit)
      const name = `${made.was} ${made.change}`
      const count = (names.get(name) ?? 0) + 1
      names.set(name, count)
      return count === 1 ? made : { ...made, change: `${made.change} (${count})` }
    })
}

/** Whether it can be read at all: what cannot be is no fault that a test has to find. */
export const isReadable = ({ text }: Mutant): boolean =>
  ts.transpileModule(text, { reportDiagnostics: true, compilerOptions: { target: ts.ScriptTarget.Latest } })
    .diagnostics?.length === 0

function mutant(file: string, source: string, tree: ts.SourceFile, { from, to, by }: Edit): Mutant {
  const { line } = tree.getLineAndCharacterOfPosition(from)
  const short = (text: string) => text.replace(/\s+/g, ' ').slice(0, 80)
  return {
    ...{ file, line: line + 1 },
    was: short(source.split('\n')[line]!.trim()),
    change: `${short(source.slice(from, to))} → ${by === ';' ? 'nothing' : short(by)}`,
    text: source.slice(0, from) + by + source.slice(to),
  }
}

/** Types, imports, and what is said to those who build. */
function isNoCode(node: ts.Node): boolean {
  if (ts.isImportDeclaration(node) || ts.isExportDeclaration(node) || ts.isTypeNode(node)) return true
  if (ts.isInterfaceDeclaration(node) || ts.isTypeAliasDeclaration(node)) return true
  if (ts.isCallExpression(node) && /^console\./.test(node.expression.getText())) return true
  return ts.isNewExpression(node) && /Error$/.test(node.expression.getText())
}

function editsOf(node: ts.Node, tree: ts.SourceFile): Edit[] {
  const [from, to] = [node.getStart(tree), node.getEnd()]
  const text = node.getText(tree)
  const whole = (by: string): Edit[] => [{ from, to, by }]
  const negated = (condition: ts.Expression): Edit[] =>
    isComparison(condition, tree)
      ? []
      : [{ from: condition.getStart(tree), to: condition.getEnd(), by: `!(${condition.getText(tree)})` }]
  if (ts.isBinaryExpression(node)) return swapped(node.operatorToken, tree)
  if (ts.isPrefixUnaryExpression(node) || ts.isPostfixUnaryExpression(node)) return unary(node, tree)
  if (node.kind === ts.SyntaxKind.TrueKeyword) return whole('false')
  if (node.kind === ts.SyntaxKind.FalseKeyword) return whole('true')
  if (ts.isNumericLiteral(node)) return whole(String(Number(text.replaceAll('_', '')) + 1))
  if (ts.isStringLiteral(node) || ts.isNoSubstitutionTemplateLiteral(node))
    return isName(node) ? [] : whole(node.text === '' ? "'mutant'" : "''")
  if (ts.isIfStatement(node) || ts.isWhileStatement(node)) return negated(node.expression)
  if (ts.isConditionalExpression(node)) return negated(node.condition)
  if (ts.isExpressionStatement(node)) return isRemovable(node) ? whole(';') : []
  if (ts.isBlock(node) && isVoid(node)) return whole('{}')
  if (node.kind === ts.SyntaxKind.QuestionDotToken)
    return [{ from, to, by: tree.text[to] === '(' || tree.text[to] === '[' ? '' : '.' }]
  if (ts.isIdentifier(node) && Object.hasOwn(methods, text) && isCalled(node)) return whole(methods[text]!)
  return []
}

function swapped(token: ts.Node, tree: ts.SourceFile): Edit[] {
  const by = swaps[token.getText(tree)]
  return by === undefined ? [] : [{ from: token.getStart(tree), to: token.getEnd(), by }]
}

function unary(node: ts.PrefixUnaryExpression | ts.PostfixUnaryExpression, tree: ts.SourceFile): Edit[] {
  const [from, to] = [node.getStart(tree), node.getEnd()]
  const operand = node.operand.getText(tree)
  const isPrefix = ts.isPrefixUnaryExpression(node)
  const put = (sign: string) => [{ from, to, by: isPrefix ? sign + operand : operand + sign }]
  if (node.operator === ts.SyntaxKind.PlusPlusToken) return put('--')
  if (node.operator === ts.SyntaxKind.MinusMinusToken) return put('++')
  const isSign =
    node.operator === ts.SyntaxKind.ExclamationToken || node.operator === ts.SyntaxKind.MinusToken
  return isSign ? [{ from, to, by: operand }] : []
}

/** A key, not a value. */
const isName = (node: ts.Node) => ts.isPropertyAssignment(node.parent) && node.parent.name === node

/** Its operator can be changed: to negate it as a whole would be the same again. */
const isComparison = (node: ts.Expression, tree: ts.SourceFile) =>
  (ts.isBinaryExpression(node) && /^[!=]==$/.test(node.operatorToken.getText(tree))) ||
  (ts.isPrefixUnaryExpression(node) && node.operator === ts.SyntaxKind.ExclamationToken)

const isRemovable = (node: ts.ExpressionStatement) => !/^(super\(|console\.)/.test(node.getText())

/** The body of a function that gives nothing back. */
function isVoid(block: ts.Block): boolean {
  const { parent } = block
  if (!ts.isFunctionLike(parent) || ts.isConstructorDeclaration(parent) || block.statements.length === 0)
    return false
  let returns = false
  const look = (node: ts.Node): void => {
    if (ts.isReturnStatement(node) && node.expression) returns = true
    if (!ts.isFunctionLike(node)) ts.forEachChild(node, look)
  }
  ts.forEachChild(block, look)
  return !returns
}

const isCalled = ({ parent }: ts.Node) =>
  ts.isPropertyAccessExpression(parent) && ts.isCallExpression(parent.parent)
