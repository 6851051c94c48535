export const papers = ['a4', 'a3'] as const
export type Paper = (typeof papers)[number]

/** The paper that the next map is printed on. */
class Printing {
  paper = $state<Paper>('a4')
}

export const printing = new Printing()
