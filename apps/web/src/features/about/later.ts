export { readFreeText } from '@botgarten/content'
