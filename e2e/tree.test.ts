import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { changesOf, shortened } from './tree.ts'

const lines = fc.array(fc.constantFrom('- list:', '  - listitem: a', '  - listitem: b', '- button "Start"'))

describe('the tree of a page', () => {
  test('has five items of a long list, however many there are', () => {
    const items = ['a', 'b', 'c', 'd', 'e', 'f', 'g'].flatMap((name) => [
      `  - listitem:`,
      `    - link "${name}"`,
    ])
    const short = shortened(['- list:', ...items, '- button "Start"'])
    expect(short.filter((line) => line.includes('link'))).toEqual(
      ['a', 'b', 'c', 'd', 'e'].map((name) => `    - link "${name}"`),
    )
    expect(short.slice(-2)).toEqual(['  - more of listitem', '- button "Start"'])
  })

  test('counts the items of each list alone', () => {
    const list = ['- list:', ...Array.from({ length: 5 }, () => '  - listitem: a')]
    expect(shortened([...list, ...list])).toEqual([...list, ...list])
  })

  test('leaves out what Blockly says of its blocks', () => {
    const blocks = [
      '- application "Blocks":',
      '  - tree "Toolbox":',
      '    - treeitem "Math"',
      '- button "Start"',
    ]
    expect(shortened(blocks)).toEqual(['- application "Blocks":', '- button "Start"'])
  })
})

describe('what a press changes', () => {
  test('is what went and what came', () => {
    expect(changesOf(['- button "Start"'], ['- dialog:', '  - button "OK"'])).toEqual([
      '- button "Start"',
      '+ dialog:',
      '+   button "OK"',
    ])
  })

  test('is nothing for a tree and itself, and everything for an empty page', () => {
    fc.assert(
      fc.property(lines, (tree) => {
        expect(changesOf(tree, tree)).toEqual([])
        expect(changesOf([], tree)).toHaveLength(tree.length)
      }),
    )
  })

  test('counts lines that are alike: two of three that go are two changes', () => {
    const three = Array.from({ length: 3 }, () => '- button "More"')
    expect(changesOf(three, three.slice(2))).toHaveLength(2)
  })
})
