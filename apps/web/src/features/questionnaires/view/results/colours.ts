/** From very negative to very positive; told apart without red and green, and by the numbers in them. */
export const colours = ['#B4503A', '#EBA88F', '#E2D5BD', '#8FC0B4', '#1F7A72'] as const

/** Letters on the two ends are white. */
export const onColour = (at: number): string => (at === 0 || at === 4 ? '#FFFFFF' : '#3A2A20')
