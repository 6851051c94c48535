import { describe, expect, it } from 'vitest'
import { readCardText } from '../index.ts'

const card = (goal = '**Go!** Bo drives.', story = 'Once upon a *time*.') => `# Title

## Story

${story}

## Goal

${goal}

## Checks

- near: comes near

## Hint 1

One.

## Hint 2

- two
- **three**

## Hint 3

Four.

## Further

1. five
`

describe('the words of a card', () => {
  it('are read section by section as a syntax tree', () => {
    const text = readCardText(card())
    expect(text.title).toBe('Title')
    expect(text.goal).toEqual({ call: 'Go!', sentence: 'Bo drives.' })
    expect(text.story).toEqual([
      {
        type: 'paragraph',
        children: [
          { type: 'text', value: 'Once upon a ' },
          { type: 'emphasis', children: [{ type: 'text', value: 'time' }] },
          { type: 'text', value: '.' },
        ],
      },
    ])
    expect(text.checks).toEqual({ near: 'comes near' })
    expect(text.hints).toHaveLength(3)
    expect(text.hints[1]![0]).toMatchObject({ type: 'list', ordered: false })
    expect(text.further[0]).toMatchObject({ type: 'list', ordered: true })
  })

  it.each([
    ['HTML', '<b onclick="x()">Go</b>', /html/],
    ['a picture', '![x](https://elsewhere.example/x.png)', /image/],
    ['a link', '[x](javascript:alert(1))', /link/],
    ['code', '`x`', /inlineCode/],
  ])('refuse %s by name', (_, story, name) => {
    expect(() => readCardText(card(undefined, story))).toThrow(name)
  })

  it('name what is missing', () => {
    expect(() => readCardText(card('Bo drives.'))).toThrow('Goal')
    expect(() => readCardText(card().replace('## Hint 2', '## Hint two'))).toThrow('Hint 2')
    expect(() => readCardText(card().replace('near:', 'near'))).toThrow('"near comes near"')
    expect(() => readCardText(card().replace('# Title', 'Title'))).toThrow('first line')
  })
})
