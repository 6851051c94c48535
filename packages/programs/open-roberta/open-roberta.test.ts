import { timed } from '@botgarten/numbers/testing/processor'
import { describe, expect, it } from 'vitest'
import { parseProject, ProjectError } from '../index.ts'
import { xmlTree } from '../testing/xml-tree.ts'
import { readOpenRoberta, writeOpenRoberta } from './index.ts'

const ns = 'http://de.fhg.iais.roberta.blockly'
const file = (blocks: string, { robot = 'robottype="ev3"', rest = '' } = {}) =>
  `<export xmlns="${ns}"><program><block_set ${robot} xmlversion="3.1" description="" tags="">` +
  `<instance x="1" y="2">${blocks}</instance></block_set></program>${rest}</export>`

function refusal(text: string): ProjectError {
  try {
    readOpenRoberta(text)
  } catch (error) {
    expect(error).toBeInstanceOf(ProjectError)
    return error as ProjectError
  }
  throw new Error('It was opened.')
}

function expectToReturn(text: string) {
  const written = writeOpenRoberta(readOpenRoberta(text))
  expect(xmlTree(written)).toEqual(xmlTree(text))
}

describe('what Open Roberta may write beside blocks', () => {
  it.each([
    [
      'a comment with its place',
      '<block type="a" id="1"><comment w="176" h="65" pinned="true">two\nlines &amp; more</comment></block>',
    ],
    [
      'switched off and on',
      '<block type="a" id="1" disabled="true" collapsed="true" inline="false"/><block type="a" id="2" disabled="false" collapsed="false" inline="true"/>',
    ],
    [
      'everything at once in its order',
      '<block type="a" id="1" deletable="false" movable="false" editable="false" error_attribute="true"><mutation items="1"/><field name="F"> x </field><comment w="1" h="2" pinned="false"/><error w="1" h="2" pinned="true">no</error><warning w="1" h="2" pinned="false">hm</warning><data>{"a": "&lt;"}</data><hide name="P" value="NO PORT"/><value name="V"><block type="b" id="2"/></value><statement name="S"><block type="c" id="3"/></statement></block>',
    ],
    [
      'a shadow',
      '<block type="a" id="1"><value name="V"><shadow type="math_number" id="2" intask="true"><field name="NUM">1</field></shadow></value></block>',
    ],
    [
      'a shadow under a block',
      '<block type="a" id="1"><value name="V"><shadow type="math_number" id="2"><field name="NUM">1</field></shadow><block type="b" id="3"/></value></block>',
    ],
    [
      'a block that is called a shadow',
      '<block type="a" id="1"><value name="V"><block type="b" id="3" shadow="true"><field name="F">1</field></block></value></block>',
    ],
    ['one id for several blocks', '<block type="a" id="1"/><block type="a" id="1"/><block type="b" id="1"/>'],
    [
      'ids that are no good',
      '<block type="a" id=""/><block type="a" id="__proto__"/><block type="b" id="constructor"/>',
    ],
    [
      'odd characters',
      '<block type="a" id="&lt;&quot;&amp;&#10;\'"><field name="F">&#13; &lt;b&gt; äöü 🤖 ]]&gt;</field></block>',
    ],
    [
      'branches of an unknown block',
      '<block type="new" id="1"><repetitions><value name="IF0"><block type="b" id="2"/></value><statement name="DO0"><block type="c" id="3"/></statement></repetitions></block>',
    ],
    [
      'branches without their wrapper',
      '<block type="robControls_ifElse" id="1"><mutation else="1"/><value name="IF0"><block type="b" id="2"/></value><statement name="ELSE"><block type="c" id="3"/></statement></block>',
    ],
    [
      'eleven branches in their order',
      `<block type="robControls_wait_for" id="1"><mutation wait="11"/><repetitions>${Array.from({ length: 12 }, (_, k) => `<value name="WAIT${k}"><block type="b" id="w${k}"/></value><statement name="DO${k}"><block type="c" id="d${k}"/></statement>`).join('')}</repetitions></block>`,
    ],
    [
      'arguments of a function',
      '<block type="f" id="1"><mutation name="doIt" output_type="Number"><arg name="x" type="Number"/><arg name="x" type="Array_Number"/></mutation></block>',
    ],
  ])('%s: comes back as it was', (_, blocks) => {
    expectToReturn(file(blocks))
  })

  it.each([
    ['no configuration', file('<block type="a" id="1"/>')],
    ['no version and no robot', file('<block type="a" id="1"/>', { robot: '' })],
    [
      'nothing at all',
      `<export xmlns="${ns}"><program><block_set/></program><config><block_set/></config></export>`,
    ],
    ['the fractions of a place', file('').replace('x="1"', 'x="-1.5"')],
  ])('%s: comes back as it was', (_, text) => {
    expectToReturn(text)
  })

  it('opens with a prefix, a first line, remarks, raw text and another end of lines', () => {
    const text = `\uFEFF<?xml version="1.0"?>\r\n<!-- hello --><or:export xmlns:or="${ns}"><or:program><or:block_set><or:instance x="1" y="2"><or:block type="text" id="1"><or:field name="TEXT"><![CDATA[a <b>\r\nc]]></or:field></or:block></or:instance></or:block_set></or:program></or:export>`
    expect(readOpenRoberta(text).stacks[0]!.blocks[0]!.fields).toEqual({ TEXT: 'a <b>\nc' })
  })

  it('what opens can be kept in a project, blocks of one id included', () => {
    const program = readOpenRoberta(file('<block type="a" id="1"/><block type="a" id="1"/>'))
    const robot = { id: 'r', pose: { x: 1, y: 1, heading: 0 }, program: 'main', brain: '' }
    const config = { wheelDiameter: 5.6, trackWidth: 18, sensors: {}, drive: { left: 'C', right: 'B' } }
    const world = {
      size: { width: 9, height: 9 },
      floor: { colour: '#FFFFFF' },
      areas: [],
      lines: [],
      obstacles: [],
    }
    const project = {
      ...{ botgarten: 1, name: 'x', programs: { main: program }, brains: {}, assets: {} },
      world: { ...world, robots: [{ ...robot, config }] },
    }
    expect(parseProject(JSON.stringify(project)).programs['main']).toEqual(program)
  })
})

describe('a file that is not opened', () => {
  const block = '<block type="a" id="1"/>'

  it.each([
    ['nothing', '', 'notXml', {}],
    ['a text', 'hello', 'notXml', { line: 1 }],
    ['a project', '{"botgarten":1}', 'notXml', { line: 1 }],
    ['a cut file', file(block).slice(0, -20), 'notXml', { line: 1 }],
    ['a broken file', `<export\n>\n<</export>`, 'notXml', { line: 3 }],
    ['a character that XML does not have', file('<block type="a\uFFFF" id="1"/>'), 'notXml', { line: 1 }],
    [
      'the number of such a character',
      file('<block type="a" id="1"><field name="F">&#0;</field></block>'),
      'notXml',
      { line: 1 },
    ],
    ['a web page', '<html><body/></html>', 'notOpenRoberta', {}],
    ['another namespace', file(block).replace(ns, 'http://www.w3.org/1999/xhtml'), 'notOpenRoberta', {}],
    ['a prefix from nowhere', file('<x:block type="a" id="1"/>'), 'notXml', { line: 1 }],
    ['a program inside a program', file(file(block)), 'notOpenRoberta', {}],
    ['another order of parts', `<export><config/><program/></export>`, 'notOpenRoberta', {}],
    ['two programs', file(block, { rest: '<program/>' }), 'notOpenRoberta', {}],
    ['a program without blocks', '<export><program/></export>', 'notOpenRoberta', {}],
    ['a script', file('<script>x</script>'), 'notOpenRoberta', {}],
    ['a script in a block', file('<block type="a" id="1"><script/></block>'), 'notOpenRoberta', {}],
    ['text beside blocks', file(`hello${block}`), 'notOpenRoberta', {}],
    ['a block without a type', file('<block id="1"/>'), 'notOpenRoberta', {}],
    ['a place that is none', file(block).replace('x="1"', 'x="left"'), 'notOpenRoberta', {}],
    [
      'two fields of one name',
      file('<block type="a" id="1"><field name="F"/><field name="F"/></block>'),
      'notOpenRoberta',
      {},
    ],
    [
      'two blocks in one hole',
      file(`<block type="a" id="1"><value name="V">${block}${block}</value></block>`),
      'notOpenRoberta',
      {},
    ],
    [
      'a name that reaches into every object',
      file('<block type="a" id="1"><field name="__proto__">1</field></block>'),
      'notOpenRoberta',
      {},
    ],
    [
      'a reserved name in a mutation',
      file('<block type="a" id="1"><mutation __proto__="1"/></block>'),
      'notOpenRoberta',
      {},
    ],
    [
      'a text without end',
      file(`<block type="a" id="1"><field name="F">${'x'.repeat(20_001)}</field></block>`),
      'notOpenRoberta',
      {},
    ],
    ['another robot', file(block, { robot: 'robottype="mbot"' }), 'otherRobot', { robot: 'mbot' }],
    [
      'another robot in its configuration',
      file(block, { rest: '<config><block_set robottype="nxt"/></config>' }),
      'otherRobot',
      { robot: 'nxt' },
    ],
    [
      'entities that blow up',
      `<!DOCTYPE x [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;&a;">]>${file('&b;')}`,
      'unsafeXml',
      {},
    ],
    [
      'an entity from outside',
      `<!DOCTYPE x [<!ENTITY a SYSTEM "file:///etc/passwd">]>${file('&a;')}`,
      'unsafeXml',
      {},
    ],
    ['an entity that nobody knows', file('&hello;'), 'notXml', { line: 1 }],
    ['an entity of HTML', file('&nbsp;'), 'notXml', { line: 1 }],
    [
      'blocks in blocks without end',
      file('<block type="a" id="1"><statement name="S">'.repeat(5000)),
      'tooDeep',
      {},
    ],
    ['100,000 blocks', file('<block type="a" id="1"/>'.repeat(100_000)), 'tooManyBlocks', { most: 10_000 }],
    ['50 MB', file(' '.repeat(50_000_000)), 'tooBig', {}],
  ])('%s: says why, within a second of the processor', (_, text, reason, facts) => {
    const { result: error, seconds } = timed(() => refusal(text))
    expect(error.reason).toBe(reason)
    expect(error.facts).toMatchObject(facts)
    expect(seconds).toBeLessThan(1)
  })

  it('leaves nothing behind in other objects', () => {
    refusal(file('<block type="a" id="1"><field name="__proto__">1</field></block>'))
    expect(Object.keys(Object.prototype)).toEqual([])
  })
})

it('characters that XML has no place for are replaced', () => {
  const fields = { A: 'a\0b\u0008\uFFFE', B: '\uD83E', C: '\uD83E\uDD16\t\n\r' }
  const stacks = [{ x: 0, y: 0, blocks: [{ id: '1', type: 'a', fields }] }]
  const written = writeOpenRoberta({ stacks, config: { stacks: [] } })
  const read = readOpenRoberta(written).stacks[0]!.blocks[0]!.fields
  expect(read).toEqual({ A: 'a\uFFFDb\uFFFD\uFFFD', B: '\uFFFD', C: '\uD83E\uDD16\t\n\r' })
})

it('what a stranger’s project says about shadows is not trusted when it is written', () => {
  const flags = { 'under.V': '{"id":"1"', 'under.W': '{"id":"x","type":"y","shadow":true,"values":3}' }
  const values = { V: { id: '2', type: 'b' }, W: { id: '3', type: 'b' } }
  const stacks = [{ x: 0, y: 0, blocks: [{ id: '1', type: 'a', values, flags }] }]
  const written = writeOpenRoberta({ stacks, config: { stacks: [] } })
  expect(readOpenRoberta(written).stacks[0]!.blocks[0]!.values).toEqual(values)
})

describe('files that are made to take long', () => {
  const many = (name: (index: number) => string) =>
    Array.from({ length: 200_000 }, (_, index) => name(index)).join(' ')
  it.each([
    ['attributes', `<export xmlns="${ns}" ${many((index) => `a${index}="1"`)}/>`],
    ['namespaces', `<export ${many((index) => `xmlns:a${index}="x"`)}/>`],
  ])('an element with 200,000 %s is refused within two seconds of the processor', (_, text) => {
    const { result, seconds } = timed(() => refusal(text))
    expect(result.reason).toBe('notOpenRoberta')
    expect(seconds).toBeLessThan(2)
  })

  it.each([0, 1])('a long text is read whole, wherever it is cut in reading (%i)', (shift) => {
    const data = 'x'.repeat(shift) + '😀'.repeat(90_000)
    const { stacks } = readOpenRoberta(file(`<block type="a" id="1"><data>${data}</data></block>`))
    expect(stacks[0]!.blocks[0]!.data === data).toBe(true)
  })
})

it('what a block has twice is named', () => {
  const twice = (parts: string) => refusal(file(`<block type="a" id="1">${parts}</block>`)).message
  expect(twice('<comment>x</comment><comment>y</comment>')).toContain('A block has two comments.')
  expect(twice('<mutation items="1"/><mutation items="2"/>')).toContain('A block has two mutations.')
})
