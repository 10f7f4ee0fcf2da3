// Every word of the page stands in the table, with its German; and the table has nothing that the page does not say.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { test } from 'node:test';
import { root } from './support/server.mjs';

const ts = createRequire(new URL('../../web/package.json', import.meta.url))('typescript');
const src = join(root, 'web/src');
const files = readdirSync(src, { recursive: true }).filter((name) => /\.tsx?$/.test(name)).sort();
const parsed = (name) => ts.createSourceFile(name, readFileSync(join(src, name), 'utf8'), ts.ScriptTarget.Latest, true, name.endsWith('x') ? ts.ScriptKind.TSX : ts.ScriptKind.TS);

const each = (node, see) => {
  see(node);
  ts.forEachChild(node, (child) => each(child, see));
};

/** The sentence of t`…`, with {0}, {1} … for its values. */
function sentenceOf({ template }) {
  const parts = ts.isNoSubstitutionTemplateLiteral(template) ? [template.text] : [template.head.text, ...template.templateSpans.map(({ literal }) => literal.text)];
  return parts.reduce((all, part, i) => `${all}{${i - 1}}${part}`).trim();
}

function wordsUsed() {
  const used = new Set();
  for (const name of files) {
    each(parsed(name), (node) => {
      if (ts.isTaggedTemplateExpression(node) && node.tag.getText() === 't') used.add(sentenceOf(node));
      if (ts.isCallExpression(node) && node.expression.getText() === 'plural') {
        const [, one, many] = node.arguments;
        used.add(one.text);
        used.add(many ? many.text : `${one.text}s`);
      }
    });
  }
  return used;
}

function table() {
  const rows = new Map();
  each(parsed('german.ts'), (node) => {
    if (!ts.isPropertyAssignment(node)) return;
    assert.ok(!rows.has(node.name.text), `twice in the table: ${node.name.text}`);
    rows.set(node.name.text, node.initializer.text);
  });
  return rows;
}

test('the table has the German of all that the page says, and nothing else', () => {
  const [used, rows] = [wordsUsed(), table()];
  assert.ok(used.size > 500, `${used.size} words are found`);
  assert.deepEqual([...used].filter((words) => !rows.has(words)), [], 'said without German');
  assert.deepEqual([...rows.keys()].filter((words) => !used.has(words)), [], 'in the table and never said');
});

test('both languages have the same values in a sentence', () => {
  const values = (text) => [...text.matchAll(/\{\d+\}/g)].map(([value]) => value).sort().join();
  for (const [english, german] of table()) assert.equal(values(german), values(english), english);
});

/** Attributes that are read or seen. */
const SEEN = ['label', 'hint', 'title', 'ask', 'aria-label', 'placeholder', 'alt', 'says'];

test('no view says a word that is not in the table', () => {
  const bare = [];
  for (const name of files) {
    each(parsed(name), (node) => {
      if (ts.isJsxText(node) && /[a-z]{2}/i.test(node.text) && node.text.trim() !== 'tramline') bare.push(`${name}: ${node.text.trim()}`);
      if (ts.isJsxAttribute(node) && SEEN.includes(node.name.getText()) && node.initializer && ts.isStringLiteral(node.initializer) && /[a-z]{2}/i.test(node.initializer.text)) bare.push(`${name}: ${node.initializer.text}`);
    });
  }
  assert.deepEqual(bare.filter((where) => !/EPSG:/.test(where)), []);
});
